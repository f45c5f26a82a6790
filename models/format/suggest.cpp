#include <glisson/models/format/suggest.hpp>

#include <glisson/models/format/xml_tree.hpp>

#include <algorithm>
#include <numeric>

namespace glisson::detail {

int edit_distance(std::string_view raw_a, std::string_view raw_b) {
  const std::string a = lower(raw_a.substr(0, 64)), b = lower(raw_b.substr(0, 64));
  std::vector<int> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  std::iota(last.begin(), last.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last[b.size()];
}

std::string nearest(std::string_view wrong, const std::vector<std::string>& names) {
  std::string best;
  int best_distance = 1000;
  for (const auto& name : names) {
    const bool begins = wrong.size() >= 3 && same_name(std::string_view(name).substr(0, wrong.size()), wrong);
    const int distance = begins ? 1 : edit_distance(wrong, name);
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  const int limit = std::max<int>(2, static_cast<int>(best.size()) / 3);
  return best_distance <= limit && best_distance < static_cast<int>(best.size()) ? best : std::string();
}

std::string suggestion(std::string_view wrong, const std::vector<std::string>& names) {
  const auto best = nearest(wrong, names);
  if (!best.empty()) return "; did you mean " + best + "?";
  std::string text = names.empty() ? "; nothing is known here" : "; known here: ";
  for (std::size_t i = 0; i < names.size(); ++i) text += (i > 0 ? ", " : "") + names[i];
  return text;
}

}  // namespace glisson::detail
