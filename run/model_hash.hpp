// A number that two models share only if they are the same: a checkpoint belongs to one model.
#pragma once

#include <cstdint>

#include <glisson/core/model.hpp>

namespace glisson {

/// FNV-1a (Fowler, Noll, Vo 1991) over everything that changes the steps of a run. Names, units and output
/// settings do not.
std::uint64_t model_hash(const Model& model);

/// The same hash over bytes.
std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t start = 14695981039346656037u);

}  // namespace glisson
