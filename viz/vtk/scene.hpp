// Everything that a picture shows, for one step and one field at a time.
#pragma once

#include <optional>

#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>

#include <glisson/core/model.hpp>
#include <glisson/viz/colouring.hpp>
#include <glisson/viz/request.hpp>
#include <glisson/viz/series.hpp>

class vtkPolyData;

namespace glisson::viz {

class Scene {
 public:
  /// Reads the series and its last or wanted step; throws Error as the readers do.
  explicit Scene(const Request& request);

  /// Draws again from the request as it is now; `step` must exist.
  void show(int step);
  void fit_camera();

  Request& request() { return request_; }
  vtkRenderer* renderer() { return renderer_; }
  int step() const { return step_; }
  const std::vector<Step>& steps() const { return steps_; }
  const std::vector<std::string>& fields() const { return fields_; }
  /// What could not be drawn, for the user; empty: nothing.
  const std::string& note() const { return note_; }

 private:
  void light(double right, double up, double near, double intensity);
  void read_the_model();
  void choose_parts(const Colouring& colouring);
  void add_results(const Colouring& colouring);
  void add_undeformed();
  void add_model_shapes();
  void add_marks();
  std::vector<Vec3<double>> current_positions() const;
  void add_legend(const Colouring& colouring);
  vtkActor* add(vtkPolyData* surface);
  Vec3<double> cut_point() const;
  /// Of the cut, towards the eye.
  Vec3<double> cut_normal() const;

  Request request_;
  std::vector<Step> steps_;
  RunFacts facts_;
  std::optional<Model> model_;
  std::vector<detail::RawMesh> parts_;
  std::vector<bool> drawn_;  ///< [parts]
  std::vector<std::string> fields_;
  std::string note_;
  int step_ = -1;
  std::vector<std::array<double, 3>> corners_;  ///< of the boxes around what was drawn [m]
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkLookupTable> table_;
  vtkNew<vtkScalarBarActor> bar_;
  vtkNew<vtkTextActor> caption_, title_;
};

}  // namespace glisson::viz
