// The scale with its unit, and the line below the picture.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include <vtkTextProperty.h>

#include <glisson/viz/colour_map.hpp>

#include "scene.hpp"

namespace glisson::viz {
namespace {

void style(vtkTextProperty* text, int size) {
  text->SetFontFamilyToArial();
  text->SetColor(0.13, 0.15, 0.18);
  text->SetFontSize(size);
  text->BoldOff(), text->ItalicOff(), text->ShadowOff();
}

/// J is read by its distance from 1, other values with both signs by that from 0.
void fill_table(vtkLookupTable* table, const Colouring& c) {
  const bool volume = c.title.starts_with("J ");
  const double middle = volume ? 1 : 0;
  const bool diverging = volume || (c.low < 0 && c.high > 0);
  double low = c.low, high = c.high;
  if (diverging) {
    const double reach = std::max({high - middle, middle - low, 1e-12});
    low = middle - reach, high = middle + reach;
  }
  if (!(high > low)) high = low + std::max(1e-12, 1e-6 * std::abs(low));
  table->SetNumberOfTableValues(256);
  table->SetRange(low, high);
  table->SetNanColor(0.72, 0.73, 0.75, 1);
  for (int k = 0; k < 256; ++k) {
    const Rgb rgb = diverging ? diverging_colour(k / 255.0) : sequential_colour(k / 255.0);
    table->SetTableValue(k, rgb[0], rgb[1], rgb[2], 1);
  }
}

/// One colour per region; false where there are too many to tell apart.
bool fill_regions(vtkLookupTable* table, const Colouring& c) {
  std::set<double> regions;
  for (const auto& part : c.parts)
    for (const double v : part.values)
      if (std::isfinite(v) && regions.size() <= 24) regions.insert(v);
  if (!c.labels || regions.empty() || regions.size() > 24) return false;
  table->SetNumberOfTableValues(static_cast<vtkIdType>(regions.size()));
  table->IndexedLookupOn();
  int k = 0;
  for (const double v : regions) {
    table->SetAnnotation(vtkVariant(v), std::to_string(static_cast<long>(v)));
    const Rgb rgb = region_colour(k);
    table->SetTableValue(k++, rgb[0], rgb[1], rgb[2], 1);
  }
  return true;
}

}  // namespace

void Scene::add_legend(const Colouring& colouring) {
  table_->ResetAnnotations();
  table_->IndexedLookupOff();
  const bool regions = fill_regions(table_, colouring);
  if (!regions) fill_table(table_, colouring);
  const int font = std::max(11, request_.height / 46);
  bar_->SetLookupTable(table_);
  bar_->SetTitle("");
  bar_->SetNumberOfLabels(regions ? 0 : 6);
  bar_->SetLabelFormat("%-#.3g");
  bar_->UnconstrainedFontSizeOn();
  bar_->SetBarRatio(0.28);
  bar_->SetMaximumNumberOfColors(256);
  bar_->SetMaximumWidthInPixels(request_.width);
  bar_->SetPosition(0.855, 0.13);
  bar_->SetWidth(0.125), bar_->SetHeight(0.7);
  bar_->SetDrawNanAnnotation(false);
  style(bar_->GetLabelTextProperty(), font);
  style(bar_->GetAnnotationTextProperty(), font);
  std::string title = colouring.title;
  if (const auto comma = title.find(", "); comma != std::string::npos) title.replace(comma, 2, "\n");
  if (const auto is = title.find(" = "); is != std::string::npos) title.replace(is, 3, "\n");
  title_->SetInput(title.c_str());
  style(title_->GetTextProperty(), font + 1);
  title_->GetTextProperty()->SetJustificationToRight();
  title_->GetTextProperty()->SetVerticalJustificationToBottom();
  title_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  title_->SetPosition(0.98, 0.86);

  char text[200];
  const auto& s = steps_[static_cast<std::size_t>(step_)];
  std::snprintf(text, sizeof text, "t = %.4g%s", s.time, facts_.units.empty() ? "" : " s");
  std::string line = std::filesystem::path(request_.results).stem().string() + "   " + text;
  if (request_.scale != 1) {
    std::snprintf(text, sizeof text, "   displacements x %.4g", request_.scale);
    line += text;
  }
  if (request_.undeformed) line += "   grey: at rest";
  caption_->SetInput(line.c_str());
  style(caption_->GetTextProperty(), font);
  caption_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  caption_->SetPosition(0.02, 0.022);
  for (vtkProp* prop : std::initializer_list<vtkProp*>{bar_, title_, caption_}) renderer_->AddViewProp(prop);
}

}  // namespace glisson::viz
