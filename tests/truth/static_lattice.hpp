// Independent truth for the tests: a square lattice of bonded discs between platens, cut by a
// straight pressurised slit, solved quasi-statically with a sparse direct solver. It shares no code
// with the library.
//
// SI units, 2-D, per metre of thickness; bond stress and opening are positive in tension. Small
// strain in total form: forces follow from the displacements since bonding (unconfined and
// stress-free) on the geometry of bonding. Nothing slides; SlitState::slip says where it should.
// Mirror symmetry about both mid-planes leaves the upper right quarter to be solved; the slit is
// centred in the vertical mid-plane.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Sparse>

namespace truth {

struct Lattice {
  int columns = 100, rows = 100;   // both even
  double radius = 5e-3;            // R; lattice spacing and channel length are 2R
  double E = 17e9, bond_E = 17e9;  // normal stiffness = modulus, as area = length = 2R
  double stiffness_ratio = 2.5;    // normal over shear
  double tensile_strength = 8e6;
  double moment_factor = 1;  // beta, the part of a bond's bending stress that counts
  double friction = 0.5;
  double S_xx = 10e6, S_yy = 12e6;  // platen stresses, compression; must keep the platens closed
  double w0 = 6e-6, F0 = 1e5;       // aperture without contact force; force that halves it
};

struct SlitState {
  double pressure, net_pressure;  // net of S_xx
  double volume;                  // of the whole slit: sum of 2R (w - w0)
  double opening;                 // w - w0 of the two central contacts
  double tip_stress;              // bond stress of the contacts just ahead of the tips
  double other_stress;            // largest bond stress anywhere else
  double slip;                    // largest |S| - friction N of the compressed linear parts, N/m
};

class StaticSlit {
 public:
  StaticSlit(const Lattice& lattice, int broken_contacts) : box_{lattice} {
    if (box_.columns % 2 != 0 || box_.rows % 2 != 0 || broken_contacts % 2 != 0)
      throw std::invalid_argument{"StaticSlit: odd counts have no mirror symmetry"};
    connect();
    cut(broken_contacts);
    solver_.analyzePattern(stiffness());
    factorise();
  }

  SlitState at_pressure(double pressure) {
    return settle([=] { return pressure; });
  }

  /// At a fixed length, as between two breaks.
  SlitState at_volume(double volume) {
    const double scale = std::abs(volume) + 2 * box_.radius * box_.w0 * broken_contacts();
    const auto miss = [=](const SlitState& state) { return (state.volume - volume) / scale; };
    return settle([=, this] { return root(miss); });
  }

  /// Where the tips reach the tensile strength.
  SlitState at_first_break() {
    const double strength = box_.tensile_strength;
    const auto miss = [=](const SlitState& state) { return state.tip_stress / strength - 1; };
    return settle([=, this] { return root(miss); });
  }

  /// Breaks the contacts at both tips; the next state asked for is that of the longer slit.
  void grow() {
    cut(broken_contacts() + 2);
    factorise();
  }

  int broken_contacts() const { return 2 * half_; }

  /// Mean extension (xx, yy) between the innermost and the outermost discs in the state last found.
  Eigen::Vector2d mean_strain() const {
    const int first = disc(0, 0), last = disc(columns() - 1, rows() - 1);
    return (u_.segment<2>(last) - u_.segment<2>(first))
        .cwiseQuotient(2 * box_.radius * Eigen::Vector2d(columns() - 1, rows() - 1));
  }

 private:
  using Strain = Eigen::Vector3d;  // opening un, shear us, relative rotation

  struct Contact {
    Eigen::Vector<int, 6> dof;
    Strain linear, bond;  // stiffnesses; the linear ones act in compression only
    double share;         // of its energy in the quarter: 1/2 across a mid-plane
    Eigen::Matrix<double, 3, 6> B = decltype(B)::Zero();  // strain = B * displacements at dof
    bool compressed = true;
  };

  int columns() const { return box_.columns / 2; }
  int rows() const { return box_.rows / 2; }
  int disc(int c, int r) const { return 3 * (columns() * r + c); }  // ux; uy and theta follow
  int platen(int axis) const { return 3 * columns() * rows() + axis; }

  // Those across the slit's mid-plane are made first, so that they are numbered by row.
  Contact& contact(int row) { return contacts_[static_cast<std::size_t>(row)]; }

  void connect() {
    const double R = box_.radius;
    const Strain axial{1, 1 / box_.stiffness_ratio, 0}, bending{0, 0, R * R / 3};  // I/L = R^2/3
    const Strain linear = box_.E * axial, bond = box_.bond_E * (axial + bending);
    for (const int axis : {0, 1}) {
      const double nx = 1 - axis, ny = axis;
      const Eigen::Matrix3d second{{nx, ny, 0}, {-ny, nx, -R}, {0, 0, 1}};
      Eigen::Matrix3d first = -second, mirror = Strain{1 - 2 * nx, 1 - 2 * ny, -1}.asDiagonal();
      first(1, 2) = -R;  // the rotations of both discs shear the contact the same way
      for (int c = 0; c < columns(); ++c)
        for (int r = 0; r < rows(); ++r) {
          const bool mirrored = (axis == 0 ? c : r) == 0;
          const int j = disc(c, r), i = mirrored ? j : j - disc(1 - axis, axis);
          contacts_.push_back(
              {{i, i + 1, i + 2, j, j + 1, j + 2}, linear, bond, mirrored ? 0.5 : 1.0});
          contacts_.back().B << (mirrored ? first * mirror : first), second;
        }
    }
    // Platens are smooth: each has one degree of freedom, its displacement outwards.
    const auto touch = [this](int axis, int i) {
      const int at = i + axis;
      contacts_.push_back({{at, platen(axis), at, at, at, at}, {4 * box_.E, 0, 0}, {0, 0, 0}, 1});
      contacts_.back().B.topLeftCorner<1, 2>() << -1, 1;
    };
    for (int r = 0; r < rows(); ++r) touch(0, disc(columns() - 1, r));
    for (int c = 0; c < columns(); ++c) touch(1, disc(c, rows() - 1));
  }

  // Breaks the slit's bonds and wets its domains: one between each two of its rows and one beyond
  // each tip. A wet domain pushes a disc away by the pressure on the chord (R, R) it spans.
  void cut(int broken_contacts) {
    if (broken_contacts < 0 || broken_contacts > box_.rows - 2)
      throw std::invalid_argument{"StaticSlit: the tips must stay inside the lattice"};
    half_ = broken_contacts / 2;
    const double R = box_.radius;
    loads_.setZero(platen(2), 2);
    loads_(platen(0), 0) = -box_.S_xx * R * box_.rows;  // on the quarter's half of each side
    loads_(platen(1), 0) = -box_.S_yy * R * box_.columns;
    for (int r = 0; r < half_; ++r) {
      contact(r).bond.setZero();
      for (const int wetted : {r, r + 1}) loads_(disc(0, wetted), 1) += R;
    }
    if (half_ == 0) return;
    loads_(disc(0, 0), 1) += R;          // the central domain straddles the mid-plane
    loads_(disc(0, half_) + 1, 1) += R;  // along y only the last domain's push is unbalanced
  }

  Eigen::SparseMatrix<double> stiffness() const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * contacts_.size());
    for (const auto& [dof, linear, bond, share, B, compressed] : contacts_) {
      const Strain springs = share * (bond + (compressed ? 1 : 0) * linear);
      const Eigen::Matrix<double, 6, 6> K = B.transpose() * springs.asDiagonal() * B;
      for (int k = 0; k < 36; ++k)  // zeros too: the pattern stays
        entries.emplace_back(dof[k / 6], dof[k % 6], K(k));
    }
    Eigen::SparseMatrix<double> K(loads_.rows(), loads_.rows());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
  }

  void factorise() {
    solver_.factorize(stiffness());
    if (solver_.info() != Eigen::Success) throw std::runtime_error{"StaticSlit: singular"};
    responses_ = solver_.solve(loads_);
  }

  Strain strain(const Contact& contact) const { return contact.B * u_(contact.dof); }

  // Active-set iteration. While the set of compressed contacts is held the lattice is linear in the
  // pressure, so the pressure wanted is found first and the set brought up to date to it. Contacts
  // that just touch stay as they are: round-off would flip them for ever. As shear vanishes
  // abruptly on opening a solution need not exist; that takes slip far above zero.
  template <class Wanted>
  SlitState settle(Wanted pressure) {
    for (int attempt = 0; attempt < 50; ++attempt) {
      const SlitState state = respond(pressure());
      bool settled = true;
      for (Contact& each : contacts_) {
        const double un = strain(each)[0];
        if ((un < 0) == each.compressed || std::abs(un) < 1e-12 * box_.radius) continue;
        each.compressed = un < 0;
        settled = false;
      }
      if (settled) return state;
      factorise();
    }
    throw std::runtime_error{"StaticSlit: the compressed contacts do not settle"};
  }

  // Secant iteration kept inside its bracket; `miss` is relative and grows with the pressure.
  template <class Miss>
  double root(Miss miss) {
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    double p = pressure_, miss_p = miss(respond(p));
    double next = p - std::copysign(1e-5 * box_.E, miss_p);
    for (int attempt = 0; attempt < 100; ++attempt) {
      if (std::abs(miss_p) < 1e-11) return p;
      (miss_p < 0 ? low : high) = p;
      if (!(low < next && next < high)) next = (low + high) / 2;
      const double miss_next = miss(respond(next)), slope = (miss_next - miss_p) / (next - p);
      p = std::exchange(next, next - miss_next / slope);
      miss_p = miss_next;
    }
    throw std::runtime_error{"StaticSlit: no pressure gives the state asked for"};
  }

  SlitState respond(double pressure) {
    pressure_ = pressure;
    u_ = responses_.col(0) + pressure * responses_.col(1);
    const double R = box_.radius, none = -std::numeric_limits<double>::infinity();
    SlitState state{pressure, pressure - box_.S_xx, 0, 0, none, none, none};
    for (const auto& each : contacts_) {
      const Strain e = strain(each);
      const double N = -each.linear[0] * e[0], S = each.linear[1] * e[1];
      if (N > 0) state.slip = std::max(state.slip, std::abs(S) - box_.friction * N);
      if (each.bond[0] == 0) continue;
      const double extension = e[0] + box_.moment_factor * R * std::abs(e[2]);  // of a bond's edge
      double& largest = &each == &contact(half_) ? state.tip_stress : state.other_stress;
      largest = std::max(largest, each.bond[0] * extension / (2 * R));
    }
    for (int r = half_; r-- > 0;) {  // the central contact last
      const double un = strain(contact(r))[0], F = -box_.E * un;
      state.opening = F > 0 ? box_.w0 * box_.F0 / (F + box_.F0) - box_.w0 : un;
      state.volume += 4 * R * state.opening;  // with its mirror image
    }
    return state;
  }

  Lattice box_;
  int half_ = 0;  // broken contacts in the quarter
  std::vector<Contact> contacts_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  Eigen::MatrixX2d loads_, responses_;  // to the platens; to unit fluid pressure
  Eigen::VectorXd u_;
  double pressure_ = box_.S_xx;
};

struct Moduli {
  double E, nu;
};

/// Of the intact dry lattice, by a small rise of S_xx at constant S_yy.
inline Moduli moduli(Lattice lattice) {
  const auto strain = [&] {
    StaticSlit dry{lattice, 0};
    dry.at_pressure(0);
    return dry.mean_strain();
  };
  const Eigen::Vector2d before = strain();
  const double rise = 1e-2 * std::exchange(lattice.S_xx, 1.01 * lattice.S_xx);
  const Eigen::Vector2d change = strain() - before;
  return {-rise / change[0], -change[1] / change[0]};
}

struct BreakEvent {
  int broken_contacts;  // before the break
  double time, length;
  SlitState state;  // at the break pressure of this length
};

/// Injection at a constant rate: the first break of each even length. Where a longer slit breaks
/// at less volume than a shorter one it grows through at once, at the volume already injected.
inline std::vector<BreakEvent> staircase(const Lattice& lattice, int first, int last, double rate) {
  std::vector<BreakEvent> events;
  StaticSlit slit{lattice, first};
  for (double time = -std::numeric_limits<double>::infinity();; slit.grow()) {
    const SlitState state = slit.at_first_break();
    if (state.other_stress > lattice.tensile_strength)
      throw std::runtime_error{"staircase: a bond away from the tips breaks first"};
    time = std::max(time, state.volume / rate);
    const int n = slit.broken_contacts();
    events.push_back({n, time, 2 * lattice.radius * n, state});
    if (n + 2 > last) return events;
  }
}

}  // namespace truth
