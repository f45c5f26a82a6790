#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <glisson/core/base/error.hpp>
#include <glisson/models/format/read_model.hpp>

#include "data.hpp"

namespace glisson::viz {

Scene::Scene(const Request& request)
    : request_(request), steps_(read_series(request.results)), facts_(facts_beside(request.results)) {
  renderer_->SetBackground(0.965, 0.968, 0.972);
  light(0.2, 0.35, 1, 0.85), light(-0.7, 0.1, 0.6, 0.22), light(0.1, 1, 0.25, 0.3);
  const int step = step_index(request.step, steps_.size());
  parts_ = read_step(steps_[static_cast<std::size_t>(step)]);
  fields_ = field_names(parts_);
  read_the_model();
  show(step);
  fit_camera();
}

/// From a place relative to the eye: right, up, towards it.
void Scene::light(double right, double up, double near, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(right, up, near);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer_->AddLight(light);
}

/// A model that the user names must fit; one that summary.json names is left out where it does not.
void Scene::read_the_model() {
  const bool named = !request_.model.empty();
  const std::string file = named ? request_.model : facts_.model_file;
  if (file.empty()) {
    if (request_.loads) note_ = "No simulation file is known here, so no loads are drawn; give --model FILE.";
    return;
  }
  try {
    Model model = read_model(file);
    if (model.mesh.X.size() != parts_[0].X.size())
      throw Error(ErrorKind::input, "its mesh has not as many nodes as the results", {file});
    if (facts_.units.empty()) facts_.units = model.units;
    model_ = std::move(model);
  } catch (const Error& error) {
    if (named) throw;
    note_ = std::string("Rigid bodies and loads are not drawn: ") + error.what();
  }
}

void Scene::show(int step) {
  if (step != step_ && step_ >= 0) parts_ = read_step(steps_[static_cast<std::size_t>(step)]);
  step_ = step;
  const Colouring colouring = colour_by(parts_, request_.field, facts_.units);
  renderer_->RemoveAllViewProps();
  corners_.clear();
  choose_parts(colouring);
  add_results(colouring);
  if (request_.undeformed) add_undeformed();
  if (model_) add_model_shapes();
  add_legend(colouring);
}

vtkActor* Scene::add(vtkPolyData* surface) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer_->AddActor(actor);
  for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n) {
    auto& x = corners_.emplace_back();
    surface->GetPoint(n, x.data());
  }
  return actor;
}

Vec3<double> Scene::cut_point() const {
  const Cut& cut = *request_.cut;
  if (!cut.share) return cut.point;
  double low = 1e300, high = -1e300;
  for (const auto& part : parts_)
    for (const auto& x : part.X)
      low = std::min(low, dot(x, cut.normal)), high = std::max(high, dot(x, cut.normal));
  return (low + *cut.share * (high - low)) * cut.normal;
}

Vec3<double> Scene::cut_normal() const {
  const Vec3<double>& n = request_.cut->normal;
  return dot(n, request_.eye) < 0 ? -1.0 * n : n;
}

/// Shells show their faces; the mid-surface stands for them where only it has the field.
void Scene::choose_parts(const Colouring& colouring) {
  const auto faces = faces_of_parts(steps_[static_cast<std::size_t>(step_)]);
  drawn_.assign(parts_.size(), true);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (faces[p] < 0) continue;
    const auto other = static_cast<std::size_t>(faces[p]);
    const auto& values = colouring.parts[other].values;
    const bool coloured =
        std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    drawn_[coloured ? p : other] = false;
  }
}

void Scene::add_results(const Colouring& colouring) {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (!drawn_[p]) continue;
    auto grid = grid_of(parts_[p], colouring.parts[p], request_.scale);
    if (request_.cut) grid = cut_grid(grid, cut_point(), cut_normal());
    vtkActor* actor = add(surface_of(grid));
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
    mapper->ScalarVisibilityOn();
    mapper->SetLookupTable(table_);
    mapper->UseLookupTableScalarRangeOn();
    mapper->InterpolateScalarsBeforeMappingOn();
    // Shells lie on the solids that they cover: they are drawn a little nearer.
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-static_cast<double>(p),
                                                                 -2.0 * static_cast<double>(p));
    actor->GetProperty()->SetAmbient(0.16);
    actor->GetProperty()->SetDiffuse(0.86);
    if (!request_.edges) continue;
    actor->GetProperty()->EdgeVisibilityOn();
    actor->GetProperty()->SetEdgeColor(0.18, 0.2, 0.24);
    actor->GetProperty()->SetLineWidth(0.6f);
  }
  if (corners_.empty())
    throw Error(ErrorKind::usage, "The cut leaves nothing to draw: its plane lies outside the model.");
}

void Scene::add_undeformed() {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (!drawn_[p]) continue;
    const auto& part = parts_[p];
    const Colours none{true, std::vector<double>(part.X.size(), 0.0)};
    vtkActor* actor = add(surface_of(grid_of(part, none, 0)));
    actor->GetProperty()->SetColor(0.45, 0.5, 0.58);
    actor->GetProperty()->SetOpacity(0.16);
    actor->GetProperty()->BackfaceCullingOn();
  }
}

void Scene::add_model_shapes() {
  for (const auto& body : bodies_at(*model_, steps_[static_cast<std::size_t>(step_)].time)) {
    vtkActor* actor = add(poly_data_of(body));
    actor->GetProperty()->SetColor(0.56, 0.6, 0.66);
    actor->GetProperty()->SetOpacity(0.75);
    actor->GetProperty()->SetInterpolationToGouraud();
  }
  if (request_.loads) add_marks();
}

std::vector<Vec3<double>> Scene::current_positions() const {
  auto x = parts_[0].X;
  const auto u = parts_[0].point_arrays.find("displacement");
  if (u == parts_[0].point_arrays.end() || u->second.components != 3) return x;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double* v = u->second.values.data() + 3 * n;
    x[n] = x[n] + request_.scale * Vec3<double>{v[0], v[1], v[2]};
  }
  return x;
}

void Scene::add_marks() {
  const auto x = current_positions();
  Vec3<double> low = x[0], high = x[0];
  for (const auto& p : x) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double diagonal = std::sqrt(dot(high - low, high - low));
  auto marks = marks_of(*model_, x, diagonal / 13);
  if (request_.cut) {
    const auto removed = [&](const Mark& m) { return dot(m.at - cut_point(), cut_normal()) > 0; };
    std::erase_if(marks, removed);
  }
  const Vec3<double> colours[mark_kinds] = {
      {0.15, 0.16, 0.2}, {0.75, 0.25, 0.55}, {0.85, 0.45, 0.1}, {0.83, 0.24, 0.2}, {0.2, 0.45, 0.6}};
  for (int kind = 0; kind < mark_kinds; ++kind) {
    const double size = diagonal * (kind == static_cast<int>(MarkKind::fixed) ? 0.03 : 0.05);
    const auto glyphs = glyphs_of(marks, static_cast<MarkKind>(kind), size);
    if (glyphs->GetNumberOfPoints() == 0) continue;
    const auto& c = colours[kind];
    add(glyphs)->GetProperty()->SetColor(c.x, c.y, c.z);
  }
}

/// Parallel projection along the direction of the eye; everything fits left of the scale.
void Scene::fit_camera() {
  vtkCamera* camera = renderer_->GetActiveCamera();
  const Vec3<double>& e = request_.eye;
  const bool vertical = std::abs(e.z) > 0.999;
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(e.x, e.y, e.z);
  camera->SetViewUp(0, vertical ? 1 : 0, vertical ? 0 : 1);
  camera->OrthogonalizeViewUp();
  const double* up = camera->GetViewUp();
  const Vec3<double> v{up[0], up[1], up[2]}, h = cross(v, e);
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
  for (const auto& c : corners_) {
    const Vec3<double> x{c[0], c[1], c[2]};
    const double along[3] = {dot(x, h), dot(x, v), dot(x, e)};
    for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], along[k]), high[k] = std::max(high[k], along[k]);
  }
  const double width = std::max(high[0] - low[0], 1e-12), height = std::max(high[1] - low[1], 1e-12);
  const double aspect = static_cast<double>(request_.width) / request_.height, free_share = 0.8;
  const double half = 0.5 * std::max(height / 0.86, width / (aspect * free_share * 0.93));
  const double shift = half * aspect * (1 - free_share);  // makes room on the right
  const Vec3<double> centre =
      (0.5 * (low[0] + high[0]) + shift) * h + 0.5 * (low[1] + high[1]) * v + 0.5 * (low[2] + high[2]) * e;
  const double distance = 2 * (width + height + high[2] - low[2]);
  const Vec3<double> eye = centre + distance * e;
  camera->SetFocalPoint(centre.x, centre.y, centre.z);
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetParallelScale(half);
  renderer_->ResetCameraClippingRange();
}

}  // namespace glisson::viz
