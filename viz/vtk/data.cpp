#include "data.hpp"

#include <vtkArrowSource.h>
#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3D.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>
#include <vtkTableBasedClipDataSet.h>

namespace glisson::viz {
namespace {

vtkSmartPointer<vtkPoints> points_of(const detail::RawMesh& part, double scale) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  const auto found = part.point_arrays.find("displacement");
  const bool moved = found != part.point_arrays.end() && found->second.components == 3;
  for (std::size_t n = 0; n < part.X.size(); ++n) {
    Vec3<double> x = part.X[n];
    if (moved) {
      const double* u = found->second.values.data() + 3 * n;
      x = x + scale * Vec3<double>{u[0], u[1], u[2]};
    }
    points->InsertNextPoint(x.x, x.y, x.z);
  }
  return points;
}

bool is_drawn(int code) {
  const auto use = detail::use_of(code);
  return use != detail::CellUse::point_or_line && use != detail::CellUse::unknown;
}

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> grid_of(const detail::RawMesh& part, const Colours& colours,
                                             double scale) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points_of(part, scale));
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  std::vector<vtkIdType> nodes;
  for (std::size_t c = 0; c < part.cell_count(); ++c) {
    if (!is_drawn(part.code[c])) continue;
    nodes.assign(part.cell(c).begin(), part.cell(c).end());
    grid->InsertNextCell(part.code[c], static_cast<vtkIdType>(nodes.size()), nodes.data());
    if (!colours.on_points) values->InsertNextValue(colours.values[c]);
  }
  if (colours.on_points)
    for (const double v : colours.values) values->InsertNextValue(v);
  if (colours.on_points)
    grid->GetPointData()->SetScalars(values);
  else
    grid->GetCellData()->SetScalars(values);
  return grid;
}

vtkSmartPointer<vtkPolyData> surface_of(vtkUnstructuredGrid* grid) {
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(grid);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> cut_grid(vtkUnstructuredGrid* grid, const Vec3<double>& point,
                                              const Vec3<double>& normal) {
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(point.x, point.y, point.z);
  plane->SetNormal(normal.x, normal.y, normal.z);
  vtkNew<vtkTableBasedClipDataSet> clip;
  clip->SetInputData(grid);
  clip->SetClipFunction(plane);
  clip->InsideOutOn();
  clip->Update();
  return clip->GetOutput();
}

vtkSmartPointer<vtkPolyData> poly_data_of(const Body& body) {
  vtkNew<vtkPoints> points;
  for (const auto& x : body.X) points->InsertNextPoint(x.x, x.y, x.z);
  vtkNew<vtkCellArray> cells;
  for (const auto& t : body.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> glyphs_of(const std::vector<Mark>& marks, MarkKind kind, double size) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> directions;
  directions->SetNumberOfComponents(3);
  const bool pushes = kind == MarkKind::pressure;
  for (const auto& mark : marks) {
    if (mark.kind != kind) continue;
    const bool still = dot(mark.direction, mark.direction) == 0;
    // An arrow that pushes ends on the surface, one that pulls starts there.
    const Vec3<double> at = pushes ? mark.at - size * mark.direction : mark.at;
    points->InsertNextPoint(at.x, at.y, at.z);
    directions->InsertNextTuple3(still ? 1 : mark.direction.x, mark.direction.y, mark.direction.z);
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  places->GetPointData()->SetVectors(directions);
  vtkNew<vtkGlyph3D> glyph;
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.22);
  arrow->SetTipRadius(0.16), arrow->SetShaftRadius(0.05), arrow->SetTipResolution(16);
  glyph->SetInputData(places);
  if (kind == MarkKind::fixed)
    glyph->SetSourceConnection(ball->GetOutputPort());
  else
    glyph->SetSourceConnection(arrow->GetOutputPort());
  glyph->SetScaleModeToDataScalingOff();
  glyph->SetScaleFactor(size);
  glyph->Update();
  return glyph->GetOutput();
}

}  // namespace glisson::viz
