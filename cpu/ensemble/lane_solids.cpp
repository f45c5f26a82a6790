#include <glisson/cpu/ensemble/lane_solids.hpp>

#include <algorithm>
#include <cstring>

#include <glisson/core/base/error.hpp>
#include <glisson/core/elements/h8.hpp>
#include <glisson/core/materials/prony.hpp>
#include <glisson/core/solids/section_laws.hpp>
#include <glisson/cpu/memory.hpp>

namespace glisson::lanes {
namespace {

/// Zeroed memory on a cache line boundary, as packs need it.
template <class T>
class Aligned {
 public:
  Aligned() = default;
  explicit Aligned(std::size_t count) : count_(count) {
    if (count == 0) return;
    data_.reset(static_cast<T*>(detail::allocate_untouched(count, sizeof(T))));
    std::memset(static_cast<void*>(data_.get()), 0, count * sizeof(T));
  }
  T* get() const { return data_.get(); }
  T& operator[](std::size_t i) const { return data_[i]; }
  std::size_t bytes() const { return count_ * sizeof(T); }
  void clear() { std::fill_n(data_.get(), count_, T(0)); }

 private:
  struct Release {
    void operator()(T* data) const { detail::release_untouched(data); }
  };
  std::size_t count_ = 0;
  std::unique_ptr<T[], Release> data_;
};

int kind_of(Formulation formulation) {
  switch (formulation) {
    case Formulation::t4:
      return 0;
    case Formulation::t4anp:
      return 1;
    case Formulation::h8:
    case Formulation::h8_fixed:
      return 2;
    case Formulation::h8_full:
      return 3;
  }
  return 0;
}

const LaneLaw& find_law(const LaneTable& table, const std::string& name) {
  for (int i = 0; i < table.law_count; ++i)
    if (name == table.laws[i].name) return table.laws[i];
  throw Error(ErrorKind::input, "There is no law '" + name + "'. Use LE, NH, AB, PY, TI or OG.");
}

constexpr std::size_t hourglass_place = H8::constant_count - 1;

/// Constants as floats, with the member's own hourglass stiffness taken out.
std::vector<float> shared_constants(const HostBlock<float>& host, std::vector<float>* hourglass) {
  std::vector<float> values(host.constants.size() / sizeof(float));
  std::memcpy(values.data(), host.constants.data(), host.constants.size());
  if (kind_of(host.formulation) != 2) return values;
  for (std::size_t i = hourglass_place; i < values.size(); i += H8::constant_count) {
    hourglass->push_back(values[i]);
    values[i] = 0;
  }
  return values;
}

[[noreturn]] void refuse_mesh() {
  throw Error(ErrorKind::input,
              "The members of an ensemble share one mesh, but this one has other nodes, elements or element "
              "sets than the first. Run it by itself.");
}

}  // namespace

struct LaneSolids::Block {
  HostBlock<float> host;  ///< of the first member, without its arrays
  int kind = 0;
  LaneBlock view;
  Aligned<int> nodes;
  Aligned<float> constants, hourglass, parameters, alpha, rate, history;
  std::vector<std::vector<PronyTerm>> terms;  ///< of each lane
  std::vector<double> dt;                     ///< that the rates of each lane belong to [s]

  std::size_t points() const { return static_cast<std::size_t>(host.point_count); }
  std::size_t values() const { return host.prony.size() * 6; }  ///< of a point
};

struct LaneSolids::Arrays {
  Aligned<float> u, f, pressure, nodal_pressure, zeros;
  Aligned<std::int32_t> advance;
  std::vector<const float*> from;
  std::vector<float*> to;
};

namespace {

using Hosts = std::vector<std::vector<HostBlock<float>>>;  ///< [lane][block]

/// The parameters of every member beside each other, and the bulk modulus after them. Empty lanes repeat the
/// first.
void fill_parameters(const Hosts& hosts, std::size_t b, const LaneLaw& law, std::size_t width,
                     Aligned<float>& out, LaneBlock& view) {
  const auto count = static_cast<std::size_t>(law.parameter_count);
  bool per_element = false;
  for (const auto& host : hosts) per_element = per_element || host[b].per_element;
  const std::size_t rows = per_element ? static_cast<std::size_t>(view.element_count) : 1;
  out = Aligned<float>(rows * (count + 1) * width);
  view.parameters = out.get();
  view.parameter_stride = per_element ? (count + 1) * width : 0;
  std::vector<double> own(count);
  for (std::size_t lane = 0; lane < width; ++lane) {
    const auto& host = hosts[lane < hosts.size() ? lane : 0][b];
    for (std::size_t row = 0; row < rows; ++row) {
      const float* from = host.parameters.data() + (host.per_element ? row * count : 0);
      float* to = out.get() + row * (count + 1) * width + lane;
      for (std::size_t k = 0; k < count; ++k) to[k * width] = from[k];
      std::copy_n(from, count, own.begin());
      to[count * width] = static_cast<float>(rest_moduli(law.name, own).bulk);
    }
  }
}

void fill_constants(const Hosts& hosts, std::size_t b, std::size_t width, Aligned<float>& constants,
                    Aligned<float>& hourglass, LaneBlock& view) {
  std::vector<float> springs;
  const std::vector<float> shared = shared_constants(hosts[0][b], &springs);
  constants = Aligned<float>(shared.size());
  std::copy(shared.begin(), shared.end(), constants.get());
  hourglass = Aligned<float>(springs.size() * width);
  for (std::size_t lane = 0; lane < width; ++lane) {
    std::vector<float> own;
    const auto& host = hosts[lane < hosts.size() ? lane : 0][b];
    if (shared_constants(host, &own) != shared || host.nodes != hosts[0][b].nodes) refuse_mesh();
    for (std::size_t e = 0; e < own.size(); ++e) hourglass[e * width + lane] = own[e];
  }
  view.constants = constants.get();
  view.hourglass = hourglass.get();
}

}  // namespace

/// Per section what a block is made of, and the first section that it shares a block with: sections share one
/// when their Prony terms are equal.
std::string group_key(const Model& model) {
  std::string key;
  const auto same_terms = [](const std::vector<PronyTerm>& a, const std::vector<PronyTerm>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PronyTerm& x, const PronyTerm& y) {
      return x.alpha == y.alpha && x.tau == y.tau;
    });
  };
  for (const Section& s : model.sections) {
    const auto first = std::find_if(model.sections.begin(), model.sections.end(), [&](const Section& other) {
      return same_terms(s.material.isochoric, other.material.isochoric) &&
             same_terms(s.material.volumetric, other.material.volumetric);
    });
    key += s.material.law + '/' + name_of(s.formulation) + '/' + std::to_string(s.elements.size()) + '/' +
           std::to_string(s.material.isochoric.size()) + '/' + std::to_string(s.material.volumetric.size()) +
           '/' + std::to_string(first - model.sections.begin()) + ';';
  }
  return key;
}

const LaneTable& choose_lane_table(const std::string& instruction_set) {
  const LaneTables all = lane_tables();
  for (std::size_t i = 0; i < all.count; ++i) {
    const LaneTable& table = *all.tables[i];
    const bool wanted = instruction_set == "auto" || instruction_set == table.name;
    if (wanted && table.available()) return table;
    if (wanted && instruction_set != "auto")
      throw Error(ErrorKind::device,
                  "This machine does not have the instruction set " + instruction_set + ". Use auto.");
  }
  throw Error(ErrorKind::usage, "The instruction set " + instruction_set +
                                    " is not known or none fits this machine. Use auto, or --device serial.");
}

LaneSolids::LaneSolids(const LaneTable& table, const std::vector<const Model*>& models,
                       const Numbering& numbering)
    : table_(table),
      node_count_(models[0]->mesh.node_count()),
      lane_count_(static_cast<int>(models.size())),
      arrays_(std::make_unique<Arrays>()) {
  Hosts hosts;
  for (const Model* model : models) {
    if (model->mesh.node_count() != node_count_) refuse_mesh();
    hosts.push_back(make_host_blocks<float>(*model, numbering));
    if (hosts.back().size() != hosts[0].size()) refuse_mesh();
  }
  average_ = make_average_lists(hosts[0], node_count_);
  const auto width = static_cast<std::size_t>(table.width), nodes = static_cast<std::size_t>(node_count_);
  std::size_t elements = 0;
  for (const auto& host : hosts[0]) elements += static_cast<std::size_t>(host.element_count);
  Arrays& a = *arrays_;
  a.u = Aligned<float>(3 * nodes * width);
  a.f = Aligned<float>(3 * nodes * width);
  a.zeros = Aligned<float>(4 * nodes);
  a.advance = Aligned<std::int32_t>(width);
  const bool averaged = !average_.element.empty();
  a.pressure = Aligned<float>(averaged ? elements * width : 0);
  a.nodal_pressure = Aligned<float>(averaged ? nodes * width : 0);
  a.from.resize(width);
  a.to.resize(width);
  pass_ = {a.u.get(), a.f.get(), a.nodal_pressure.get(), a.advance.get()};
  std::size_t first = 0;
  for (std::size_t b = 0; b < hosts[0].size(); ++b) {
    Block block;
    HostBlock<float>& host = hosts[0][b];
    block.kind = kind_of(host.formulation);
    block.view.element_count = host.element_count;
    block.view.law = &find_law(table, host.law);
    block.view.isochoric = host.isochoric_count;
    block.view.volumetric = static_cast<int>(host.prony.size()) - host.isochoric_count;
    fill_constants(hosts, b, width, block.constants, block.hourglass, block.view);
    fill_parameters(hosts, b, *block.view.law, width, block.parameters, block.view);
    block.nodes = Aligned<int>(host.nodes.size());
    std::copy(host.nodes.begin(), host.nodes.end(), block.nodes.get());
    block.view.nodes = block.nodes.get();
    for (const auto& own : hosts) block.terms.push_back(own[b].prony);
    block.dt.assign(models.size(), -1);
    const std::size_t terms = host.prony.size();
    block.alpha = Aligned<float>(terms * width);
    block.rate = Aligned<float>(terms * width);
    block.history = Aligned<float>(host.history_size() * width);
    block.view.alpha = block.alpha.get();
    block.view.rate = block.rate.get();
    block.view.history = block.history.get();
    block.view.pressure = averaged ? a.pressure.get() + first * width : nullptr;
    first += static_cast<std::size_t>(host.element_count);
    blocks_.push_back(std::move(block));
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    HostBlock<float>& host = hosts[0][b];
    host.constants = {}, host.nodes = {}, host.parameters = {};
    blocks_[b].host = std::move(host);
  }
}

LaneSolids::~LaneSolids() = default;

void LaneSolids::set_rates(std::span<const Request> requests) {
  const auto width = static_cast<std::size_t>(table_.width);
  for (Block& block : blocks_)
    for (std::size_t lane = 0; lane < requests.size(); ++lane) {
      const double dt = requests[lane].view.dt;
      if (requests[lane].kind != Request::Kind::forces || dt == block.dt[lane]) continue;
      block.dt[lane] = dt;
      for (std::size_t t = 0; t < block.terms[lane].size(); ++t) {
        const PronyTerm& term = block.terms[lane][t];
        const auto exact = prony_coefficients(term.alpha, term.tau, dt);
        block.alpha[t * width + lane] = static_cast<float>(exact.alpha);
        block.rate[t * width + lane] = static_cast<float>(exact.rate);
      }
    }
}

/// Displacements of the lanes that ask; the others rest.
void LaneSolids::load(Request::Kind kind, std::span<const Request> requests) {
  Arrays& a = *arrays_;
  for (std::size_t lane = 0; lane < a.from.size(); ++lane) {
    const bool asks = lane < requests.size() && requests[lane].kind == kind;
    a.from[lane] = asks ? &requests[lane].view.u->x : a.zeros.get();
    a.to[lane] = asks ? &requests[lane].view.f->x : nullptr;
    a.advance[lane] = asks && kind == Request::Kind::forces && requests[lane].view.advance ? -1 : 0;
  }
  table_.gather(a.from.data(), node_count_, a.u.get());
}

void LaneSolids::average_pressure() {
  if (average_.element.empty()) return;
  for (const Block& block : blocks_)
    if (block.kind == 1) table_.pressures(block.view, pass_);
  table_.average({node_count_, average_.begin.data(), average_.element.data(), average_.weight.data(),
                  arrays_->pressure.get(), arrays_->nodal_pressure.get()});
}

void LaneSolids::answer(Request::Kind kind, std::span<Request> requests) {
  load(kind, requests);
  if (kind != Request::Kind::hourglass_energy) average_pressure();
  if (kind == Request::Kind::forces) {
    set_rates(requests);
    arrays_->f.clear();
    for (const Block& block : blocks_) {
      const bool fast = block.kind == 0 && block.host.law == "NH" && block.host.prony.empty();
      (fast ? table_.neo_hookean : table_.forces[block.kind])(block.view, pass_);
    }
    table_.scatter(arrays_->f.get(), node_count_, arrays_->to.data());
  } else {
    std::vector<double> sums(arrays_->from.size());
    for (const Block& block : blocks_) {
      if (kind == Request::Kind::strain_energy) table_.energy[block.kind](block.view, pass_, sums.data());
      if (kind == Request::Kind::hourglass_energy && block.kind == 2)
        table_.hourglass(block.view, pass_, sums.data());
    }
    for (std::size_t lane = 0; lane < requests.size(); ++lane)
      if (requests[lane].kind == kind) requests[lane].energy = sums[lane];
  }
  for (Request& request : requests)
    if (request.kind == kind) request.kind = Request::Kind::none;
}

/// From [element][point][term][6] with W members beside each other to [point][term][6][element] of one.
std::vector<double> LaneSolids::history(int lane) const {
  const auto width = static_cast<std::size_t>(table_.width);
  std::vector<const HostBlock<float>*> hosts;
  std::vector<std::vector<float>> arrays;
  for (const Block& block : blocks_) {
    hosts.push_back(&block.host);
    const std::size_t per_element = block.points() * block.values(),
                      elements = static_cast<std::size_t>(block.host.element_count);
    auto& array = arrays.emplace_back(block.host.history_size());
    for (std::size_t e = 0; e < elements; ++e)
      for (std::size_t v = 0; v < per_element; ++v)
        array[v * elements + e] =
            block.history[(e * per_element + v) * width + static_cast<std::size_t>(lane)];
  }
  return canonical_history(hosts, arrays);
}

void LaneSolids::set_history(int lane, const std::vector<double>& history) {
  const auto width = static_cast<std::size_t>(table_.width);
  std::vector<const HostBlock<float>*> hosts;
  for (const Block& block : blocks_) hosts.push_back(&block.host);
  const auto arrays = block_history<float>(hosts, history);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Block& block = blocks_[b];
    const std::size_t per_element = block.points() * block.values();
    const auto elements = static_cast<std::size_t>(block.host.element_count);
    for (std::size_t e = 0; e < elements; ++e)
      for (std::size_t v = 0; v < per_element; ++v)
        block.history[(e * per_element + v) * width + static_cast<std::size_t>(lane)] =
            arrays[b][v * elements + e];
  }
}

std::size_t LaneSolids::memory_bytes() const {
  const Arrays& a = *arrays_;
  std::size_t bytes = a.u.bytes() + a.f.bytes() + a.pressure.bytes() + a.nodal_pressure.bytes();
  for (const Block& b : blocks_)
    bytes += b.constants.bytes() + b.nodes.bytes() + b.hourglass.bytes() + b.parameters.bytes() +
             b.history.bytes();
  return bytes;
}

}  // namespace glisson::lanes
