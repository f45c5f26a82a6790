// Results and shapes as VTK's data sets.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <glisson/viz/colouring.hpp>
#include <glisson/viz/model_shapes.hpp>

namespace glisson::viz {

/// Cells at rest position plus scale times displacement, without points and lines, coloured by the active
/// scalars "value".
vtkSmartPointer<vtkUnstructuredGrid> grid_of(const detail::RawMesh& part, const Colours& colours,
                                             double scale);
/// Outer surface with both kinds of scalars kept.
vtkSmartPointer<vtkPolyData> surface_of(vtkUnstructuredGrid* grid);
/// The side of the plane away from the eye; solids show their inside.
vtkSmartPointer<vtkUnstructuredGrid> cut_grid(vtkUnstructuredGrid* grid, const Vec3<double>& point,
                                              const Vec3<double>& normal);
vtkSmartPointer<vtkPolyData> poly_data_of(const Body& body);
/// Arrows, or balls for fixed nodes, of about `size` [m].
vtkSmartPointer<vtkPolyData> glyphs_of(const std::vector<Mark>& marks, MarkKind kind, double size);

}  // namespace glisson::viz
