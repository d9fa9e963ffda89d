/// @file
/// Everything, for the impatient. A program that needs little includes `simulator.hpp` and its four
/// policies, and compiles faster.
#pragma once

#include <hfdem/analytic/joint_crossing.hpp>
#include <hfdem/analytic/joint_strength.hpp>
#include <hfdem/analytic/kgd_regions.hpp>
#include <hfdem/analytic/plate_growth.hpp>
#include <hfdem/analytic/pore_diffusion.hpp>
#include <hfdem/analytic/pressurised_crack.hpp>
#include <hfdem/analytic/rock_fracture.hpp>
#include <hfdem/analytic/stepwise_growth.hpp>
#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/archive.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/base/version.hpp>
#include <hfdem/contact/incremental_parallel_bond.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/leakoff/carter.hpp>
#include <hfdem/measure/crack.hpp>
#include <hfdem/measure/elastic_moduli.hpp>
#include <hfdem/measure/energy_ledger.hpp>
#include <hfdem/measure/joint_test.hpp>
#include <hfdem/measure/mohr_coulomb.hpp>
#include <hfdem/measure/natural_fractures.hpp>
#include <hfdem/measure/particle_stress.hpp>
#include <hfdem/measure/path_profile.hpp>
#include <hfdem/measure/rock_tests.hpp>
#include <hfdem/measure/running_crack.hpp>
#include <hfdem/measure/sample_mean.hpp>
#include <hfdem/measure/slit.hpp>
#include <hfdem/measure/slit_modulus.hpp>
#include <hfdem/measure/toughness.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/crack_map.hpp>
#include <hfdem/observe/fracture_map.hpp>
#include <hfdem/observe/growth.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/paraview.hpp>
#include <hfdem/observe/regime_map.hpp>
#include <hfdem/observe/report.hpp>
#include <hfdem/observe/specimen_picture.hpp>
#include <hfdem/observe/stress_map.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/pressure/leaky_uniform.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/fracture_file.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/setup/specimen_file.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

// The headers that need a package.
#if __has_include(<nanoflann.hpp>)
#include <hfdem/neighbours/kd_tree.hpp>
#endif
#if __has_include(<Eigen/SparseCholesky>)
#include <hfdem/leakoff/matrix_flow.hpp>
#include <hfdem/measure/permeability.hpp>
#include <hfdem/observe/pore_map.hpp>
#include <hfdem/pressure/implicit.hpp>
#endif
#if __has_include(<boost/geometry/index/rtree.hpp>)
#include <hfdem/setup/joints.hpp>
#include <hfdem/setup/random_fractures.hpp>
#endif
