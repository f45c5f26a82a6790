// The Prony history of one section on a backend.
#pragma once

#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/loads/upload.hpp>
#include <glisson/core/model.hpp>
#include <glisson/shells/relaxation.hpp>

namespace glisson::shells {

template <Backend B, class R>
class SectionHistory {
 public:
  /// order: the place in the section of each element of the arrays.
  SectionHistory(B& backend, const std::vector<PronyTerm>& prony, std::vector<int> order)
      : backend_(&backend),
        prony_(prony),
        order_(std::move(order)),
        Y_(detail::zeros<R>(backend, size())),
        terms_(detail::reserve<PronyCoefficients<R>>(backend, prony.size())) {}

  PlaneHistory<R, R> view() const {
    return {Y_.get(), terms_.get(), static_cast<int>(prony_.size()), static_cast<int>(order_.size())};
  }
  std::size_t size() const { return rows() * order_.size(); }
  /// Coefficients for steps of dt [s].
  void set_step(double dt) {
    if (prony_.empty() || dt == dt_) return;
    std::vector<PronyCoefficients<R>> terms;
    for (const PronyTerm& term : prony_) {
      const auto exact = prony_coefficients(term.alpha, term.tau, dt);
      terms.push_back({R(exact.alpha), R(exact.rate)});
    }
    backend_->copy_in(terms.data(), terms_.get(), terms.size());
    dt_ = dt;
  }
  /// values [Pa]: in the order of the section  [element][term][3]
  void get(double* values) const {
    std::vector<R> own(size());
    if (own.empty()) return;
    backend_->copy_out(Y_.get(), own.data(), own.size());
    for_each_value([&](std::size_t of_section, std::size_t i) { values[of_section] = double(own[i]); });
  }
  void set(const double* values) {
    std::vector<R> own(size());
    if (own.empty()) return;
    for_each_value([&](std::size_t of_section, std::size_t i) { own[i] = R(values[of_section]); });
    backend_->copy_in(own.data(), Y_.get(), own.size());
  }

 private:
  std::size_t rows() const { return 3 * prony_.size(); }
  template <class Visit>
  void for_each_value(Visit&& visit) const {
    for (std::size_t e = 0; e < order_.size(); ++e)
      for (std::size_t k = 0; k < rows(); ++k)
        visit(static_cast<std::size_t>(order_[e]) * rows() + k, k * order_.size() + e);
  }

  B* backend_;
  std::vector<PronyTerm> prony_;
  std::vector<int> order_;
  Buffer<R> Y_;
  Buffer<PronyCoefficients<R>> terms_;
  double dt_ = -1;  ///< step that the coefficients belong to [s]
};

}  // namespace glisson::shells
