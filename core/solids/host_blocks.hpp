// Elements grouped into blocks that one kernel can run: same formulation, law and Prony terms. Host arrays in
// the element order of the Numbering, ready for upload.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/core/numbering.hpp>

namespace glisson {

template <class R>
struct HostBlock {
  Formulation formulation = Formulation::t4;
  std::string law;
  std::vector<PronyTerm> prony;  ///< isochoric, then volumetric
  int isochoric_count = 0, element_count = 0, nodes_per_element = 0, point_count = 1;
  bool per_element = false;
  std::vector<std::byte> constants;  ///< E::Constants<R> [element_count], or none
  std::vector<int> nodes;            ///< internal numbers [element_count][nodes_per_element]
  std::vector<R> parameters;         ///< [element_count or 1][parameter_count]
  std::vector<R> volumes;            ///< T4ANP: rest volumes [m^3] [element_count]
  std::vector<R> hourglass;  ///< H8: stiffness of rest_constants() [Pa] [element_count, or one for all]
  /// First value in the canonical history (SolidForces::history) of each element [element_count]; empty
  /// without Prony terms.
  std::vector<std::size_t> history_place;

  bool viscous() const { return !prony.empty(); }
  std::size_t history_size() const {
    return prony.size() * 6 * static_cast<std::size_t>(point_count) * static_cast<std::size_t>(element_count);
  }
};

/// Patches on devices form the constants of most elements anew from rest positions.
enum class StoredConstants { all, not_formed_anew };

template <class R>
std::vector<HostBlock<R>> make_host_blocks(const Model& model, const Numbering& numbering,
                                           StoredConstants stored = StoredConstants::all);

/// For each node the places in the element forces of all blocks, one block after the other, in the order of
/// the elements.
struct Incidence {
  std::vector<int> begin, slot;
};
template <class R>
Incidence make_incidence(const std::vector<HostBlock<R>>& blocks, int node_count);

/// For each node its T4ANP elements with their share of the volume around the node.
template <class R>
struct AverageLists {
  std::vector<int> begin, element;
  std::vector<R> weight;
};
template <class R>
AverageLists<R> make_average_lists(const std::vector<HostBlock<R>>& blocks, int node_count);

/// From [point][term][6][element] of each block to the canonical order, and back.
template <class R>
std::vector<double> canonical_history(const std::vector<const HostBlock<R>*>& blocks,
                                      const std::vector<std::vector<R>>& arrays);
template <class R>
std::vector<std::vector<R>> block_history(const std::vector<const HostBlock<R>*>& blocks,
                                          const std::vector<double>& history);

}  // namespace glisson
