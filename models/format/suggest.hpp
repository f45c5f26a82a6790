// "Did you mean ...": the nearest of some names by edit distance.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glisson::detail {

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b, without case (Damerau
/// 1964, the restricted form).
int edit_distance(std::string_view a, std::string_view b);

/// The nearest name if it is near enough to be what was meant (within a third of its length or 2 edits, or
/// its beginning); empty otherwise.
std::string nearest(std::string_view wrong, const std::vector<std::string>& names);

/// "; did you mean NAME?" or, without a near name, "; known here: A, B, C".
std::string suggestion(std::string_view wrong, const std::vector<std::string>& names);

}  // namespace glisson::detail
