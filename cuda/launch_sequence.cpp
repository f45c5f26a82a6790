#include <glisson/cuda/launch_sequence.hpp>

#include <algorithm>

namespace glisson::cuda {

bool LaunchSequence::same_arguments(std::size_t k, const LaunchSequence& other) const {
  const Launch& l = launches_[k];
  const std::size_t first = row_of(l.first_argument), last = row_of(l.first_argument + l.argument_count);
  return std::memcmp(rows_.data() + first, other.rows_.data() + first, (last - first) * sizeof(Row)) == 0;
}

LaunchSequence LaunchSequence::shape() const {
  LaunchSequence shape;
  shape.launches_ = launches_;
  shape.first_row_ = first_row_;
  return shape;
}

const std::vector<KernelCall>& LaunchSequence::calls() {
  pointers_.clear();
  calls_.clear();
  for (const std::size_t row : first_row_) pointers_.push_back(rows_.data() + row);
  for (const Launch& l : launches_)
    calls_.push_back(
        {l.kernel, l.blocks, l.threads, l.members, l.shared_bytes, pointers_.data() + l.first_argument});
  return calls_;
}

bool LaunchSequence::merges(std::size_t k, const LaunchPlace& other) const {
  const Launch &a = launches_[k], &b = other.sequence->launches_[other.launch];
  if (a.kernel != b.kernel || a.blocks != b.blocks || a.threads != b.threads ||
      a.shared_bytes != b.shared_bytes || a.argument_count != b.argument_count)
    return false;
  const std::size_t first = row_of(a.first_argument), last = row_of(a.first_argument + a.argument_count - 1);
  const Row* others = other.sequence->rows_.data() + other.sequence->row_of(b.first_argument);
  return std::memcmp(rows_.data() + first, others, (last - first) * sizeof(Row)) == 0;
}

int LaunchSequence::capacity(std::size_t k, std::size_t most_parameter_bytes) const {
  const SeveralKernel* several = launches_[k].several;
  return several && several->parameter_bytes() <= most_parameter_bytes ? several->capacity : 1;
}

void LaunchSequence::add_merged(std::span<const LaunchPlace> same) {
  const LaunchSequence& first = *same.front().sequence;
  const Launch& one = first.launches_[same.front().launch];
  const bool several = same.size() > 1;
  launches_.push_back({several ? one.several->kernel : one.kernel, nullptr, one.blocks, one.threads,
                       static_cast<int>(same.size()), one.shared_bytes, first_row_.size(),
                       one.argument_count});
  const std::size_t end = one.first_argument + one.argument_count, alone = several ? end - 1 : end;
  for (std::size_t a = one.first_argument; a < alone; ++a)
    put(first.rows_.data() + first.row_of(a), (first.row_of(a + 1) - first.row_of(a)) * sizeof(Row));
  if (!several) return;
  const std::size_t bytes = one.several->body_bytes;
  std::byte* to = make_room(static_cast<std::size_t>(one.several->capacity) * bytes);
  for (const LaunchPlace& place : same) {
    const Launch& l = place.sequence->launches_[place.launch];
    const std::size_t body = place.sequence->row_of(l.first_argument + l.argument_count - 1);
    std::memcpy(to, place.sequence->rows_.data() + body, bytes);
    to += bytes;
  }
}

namespace {

using Members = std::vector<const LaunchSequence*>;

/// Whether all launches of the p-th parts of a and b merge.
bool parts_merge(const LaunchSequence& a, const LaunchSequence& b, std::size_t p) {
  const auto [first, last] = a.part(p);
  const auto other = b.part(p);
  if (other.last - other.first != last - first) return false;
  for (std::size_t k = first; k < last; ++k)
    if (!a.merges(k, {&b, other.first + k - first})) return false;
  return true;
}

void add_parts(const Members& alike, std::size_t p, std::size_t most_parameter_bytes, LaunchSequence& to) {
  const auto [first, last] = alike.front()->part(p);
  std::vector<LaunchPlace> places;
  for (std::size_t k = 0; k < last - first; ++k) {
    places.clear();
    for (const LaunchSequence* member : alike) places.push_back({member, member->part(p).first + k});
    const auto most = static_cast<std::size_t>(alike.front()->capacity(first + k, most_parameter_bytes));
    for (std::size_t at = 0; at < places.size(); at += most)
      to.add_merged({places.data() + at, std::min(most, places.size() - at)});
  }
}

}  // namespace

void merge(std::span<const LaunchSequence* const> members, std::size_t most_parameter_bytes,
           LaunchSequence& to) {
  std::size_t parts = 0;
  for (const LaunchSequence* member : members) parts = std::max(parts, member->part_count());
  Members rest, alike, others;
  for (std::size_t p = 0; p < parts; ++p) {
    rest.clear();
    for (const LaunchSequence* member : members)
      if (p < member->part_count()) rest.push_back(member);
    while (!rest.empty()) {
      alike.clear(), others.clear();
      for (const LaunchSequence* member : rest)
        (parts_merge(*rest.front(), *member, p) ? alike : others).push_back(member);
      add_parts(alike, p, most_parameter_bytes, to);
      rest.swap(others);
    }
  }
}

}  // namespace glisson::cuda
