// Glued surfaces as a provider of a backend. Include it only where a backend is instantiated.
//
// The forces -W^T lambda of all rows end the step at W u = 0: W M^-1 W^T lambda = W u_predicted (times a
// factor of the step), solved by Chebyshev's iteration from the multipliers of the last step. What it leaves
// over is part of the next step's right-hand side. The two sides of each row get opposite forces, converged
// or not: momentum is kept to rounding.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include <glisson/contact/free_axes.hpp>
#include <glisson/contact/tied/tie_rows.hpp>
#include <glisson/core/loads/list_forces.hpp>
#include <glisson/core/loads/node_list.hpp>

namespace glisson::contact {

/// Rows and the same entries by node.
template <class R>
struct TieView {
  const int *row_begin, *row_node;
  const R* row_weight;
  const int *node_begin, *node_row;
  const R* node_weight;
  const int* internal;   ///< of each node, rising  [node_count]
  const int* free_axes;  ///< as SurfaceView        [node_count]
  Vec4<R>* lambda;       ///< [N / sqrt(kg)]  [row_count]
  Vec4<R>* change;       ///< last step of the iteration
  Vec4<R>* end;          ///< displacement at the end of the step [m]  [node_count]
  Vec4<R>* force;        ///< [N]                                      [node_count]
};

template <class R>
struct PullTied {
  static constexpr int cost = 30;
  TieView<R> tie;
  const Vec4<R>*u_predicted, *v;
  R advance_per_force;

  GLISSON_HD void operator()(int i) const {
    Vec3<R> f;
    for (int k = tie.node_begin[i]; k < tie.node_begin[i + 1]; ++k)
      f = f - tie.node_weight[k] * xyz(tie.lambda[tie.node_row[k]]);
    const int n = tie.internal[i], free = tie.free_axes[i];
    const R mobility = advance_per_force * v[n].w;
    const Vec3<R> u = xyz(u_predicted[n]);
    tie.force[i] = {f.x, f.y, f.z, R(0)};
    tie.end[i] = {free & 1 ? u.x + mobility * f.x : u.x, free & 2 ? u.y + mobility * f.y : u.y,
                  free & 4 ? u.z + mobility * f.z : u.z, R(0)};
  }
};

template <class R>
struct CloseTied {
  static constexpr int cost = 30;
  TieView<R> tie;
  R keep, gain;  ///< change <- keep change + gain (open gap)

  GLISSON_HD void operator()(int c) const {
    Vec3<R> open;
    for (int k = tie.row_begin[c]; k < tie.row_begin[c + 1]; ++k)
      open = open + tie.row_weight[k] * xyz(tie.end[tie.row_node[k]]);
    const Vec3<R> change = keep * xyz(tie.change[c]) + gain * open, sum = xyz(tie.lambda[c]) + change;
    tie.change[c] = {change.x, change.y, change.z, R(0)};
    tie.lambda[c] = {sum.x, sum.y, sum.z, R(0)};
  }
};

template <class R>
struct TiedForce : LastForces<R> {
  const Vec4<R>* found;
  GLISSON_HD Vec3<R> force(int i, int) const { return xyz(found[i]); }
};

template <Backend B, class R>
class TieForces final : public ForceProvider<R> {
 public:
  TieForces(B& backend, const Model& model, const Numbering& numbering, const TieRows& rows)
      : TieForces(backend, rows, in_order(model, numbering, rows)) {}

  std::string_view name() const override { return "tied surfaces"; }
  Space space() const override { return B::space; }
  bool needs_prediction() const override { return true; }
  bool moves_prediction() const override { return true; }
  double work() const override { return work_.total(); }

  void add_forces(const StepView<R>& step) override {
    std::vector<Vec4<R>> kept(step.advance ? 0 : std::size_t(row_count_));  // an evaluation leaves no trace
    if (!kept.empty()) backend_.copy_out(lambda_.get(), kept.data(), kept.size());
    close_gaps(step);
    work_.run(step, internal_.get(), TiedForce<R>{{last_.get()}, force_.get()});
    if (!kept.empty()) backend_.copy_in(kept.data(), lambda_.get(), kept.size());
  }
  std::vector<std::byte> save() const override {
    detail::ByteWriter out;
    out.buffer(backend_, lambda_, std::size_t(row_count_)).buffer(backend_, last_, std::size_t(node_count_));
    work_.save(out);
    return out.take();
  }
  void load(std::span<const std::byte> bytes) override {
    detail::ByteReader in(bytes, std::string(name()));
    in.buffer(backend_, lambda_, std::size_t(row_count_));
    in.buffer(backend_, last_, std::size_t(node_count_));
    work_.load(in);
    in.end();
  }

 private:
  /// Entries by node, nodes in the engine's order.
  struct Lists {
    std::vector<int> row_node, node_begin, node_row, internal, free_axes;
    std::vector<R> row_weight, node_weight;
  };
  static Lists in_order(const Model& model, const Numbering& numbering, const TieRows& rows);
  TieForces(B& backend, const TieRows& rows, const Lists& lists)
      : backend_(backend),
        row_count_(rows.row_count()),
        node_count_(static_cast<int>(rows.nodes.size())),
        steps_(rows.steps),
        low_(rows.low),
        high_(rows.high),
        row_begin_(detail::upload(backend, rows.row_begin)),
        row_node_(detail::upload(backend, lists.row_node)),
        node_begin_(detail::upload(backend, lists.node_begin)),
        node_row_(detail::upload(backend, lists.node_row)),
        internal_(detail::upload(backend, lists.internal)),
        free_axes_(detail::upload(backend, lists.free_axes)),
        row_weight_(detail::upload(backend, lists.row_weight)),
        node_weight_(detail::upload(backend, lists.node_weight)),
        lambda_(detail::zeros<Vec4<R>>(backend, std::size_t(row_count_))),
        change_(detail::zeros<Vec4<R>>(backend, std::size_t(row_count_))),
        end_(detail::zeros<Vec4<R>>(backend, std::size_t(node_count_))),
        force_(detail::zeros<Vec4<R>>(backend, std::size_t(node_count_))),
        last_(detail::zeros<Vec4<R>>(backend, std::size_t(node_count_))),
        work_(backend, node_count_) {}
  TieView<R> view() const {
    return {row_begin_.get(), row_node_.get(),    row_weight_.get(), node_begin_.get(),
            node_row_.get(),  node_weight_.get(), internal_.get(),   free_axes_.get(),
            lambda_.get(),    change_.get(),      end_.get(),        force_.get()};
  }
  void close_gaps(const StepView<R>& step) {
    const double middle = 0.5 * (high_ + low_), half = 0.5 * (high_ - low_);
    const double scale = 1 / double(step.advance_per_force);
    double rho = half / middle;
    for (int i = 0; i < steps_; ++i) {
      pull(step);
      const double next = i == 0 ? rho : 1 / (2 * middle / half - rho);
      const double keep = i == 0 ? 0 : next * rho, gain = i == 0 ? 1 / middle : 2 * next / half;
      rho = next;
      backend_.for_each(row_count_, CloseTied<R>{view(), R(keep), R(gain * scale)});
    }
    pull(step);
  }
  void pull(const StepView<R>& step) {
    backend_.for_each(node_count_, PullTied<R>{view(), step.u_predicted, step.v, step.advance_per_force});
  }

  B& backend_;
  int row_count_, node_count_, steps_;
  double low_, high_;
  Buffer<int> row_begin_, row_node_, node_begin_, node_row_, internal_, free_axes_;
  Buffer<R> row_weight_, node_weight_;
  Buffer<Vec4<R>> lambda_, change_, end_, force_, last_;
  ListWork<B, R> work_;
};

template <Backend B, class R>
typename TieForces<B, R>::Lists TieForces<B, R>::in_order(const Model& model, const Numbering& numbering,
                                                          const TieRows& rows) {
  std::map<int, int> place;  // internal node: node of the rows
  for (int k = 0; k < static_cast<int>(rows.nodes.size()); ++k)
    place[detail::internal_node(numbering, rows.nodes[std::size_t(k)])] = k;
  Lists lists;
  std::vector<int> order(rows.nodes.size()), mesh_nodes;
  for (const auto& [internal, k] : place) {
    order[std::size_t(k)] = static_cast<int>(lists.internal.size());
    lists.internal.push_back(internal);
    mesh_nodes.push_back(rows.nodes[std::size_t(k)]);
  }
  lists.free_axes = free_axes_of(mesh_nodes, model, numbering);
  std::vector<std::vector<std::pair<int, double>>> by_node(order.size());
  for (int c = 0; c < rows.row_count(); ++c)
    for (int i = rows.row_begin[std::size_t(c)]; i < rows.row_begin[std::size_t(c + 1)]; ++i) {
      const int node = order[std::size_t(rows.node[std::size_t(i)])];
      lists.row_node.push_back(node);
      lists.row_weight.push_back(R(rows.weight[std::size_t(i)]));
      by_node[std::size_t(node)].push_back({c, rows.weight[std::size_t(i)]});
    }
  lists.node_begin.push_back(0);
  for (const auto& entries : by_node) {
    for (const auto& [row, weight] : entries) {
      lists.node_row.push_back(row);
      lists.node_weight.push_back(R(weight));
    }
    lists.node_begin.push_back(static_cast<int>(lists.node_row.size()));
  }
  return lists;
}

/// Puts the ties of the model before contact, which then sees where they take the nodes.
/// mass: inertial, by internal node [kg]
template <Backend B, class R>
void add_tied_surfaces(B& backend, const Model& model, const Numbering& numbering,
                       const std::vector<double>& mass, std::vector<std::unique_ptr<ForceProvider<R>>>& to) {
  if (model.ties.empty()) return;
  std::vector<double> of_user(mass.size());
  for (std::size_t n = 0; n < mass.size(); ++n) of_user[n] = mass[std::size_t(numbering.internal_of_user[n])];
  to.insert(to.begin(),
            std::make_unique<TieForces<B, R>>(backend, model, numbering, tie_rows(model, of_user)));
}

}  // namespace glisson::contact
