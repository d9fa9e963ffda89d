/// @file
/// What two translation units, each of which includes everything, share.
#pragma once

#include <string_view>
#include <typeinfo>

#include <hfdem/hfdem.hpp>

using Kgd = hfdem::Simulator<hfdem::LinearParallelBond, hfdem::HyperbolicAperture,
                             hfdem::UniformPressure, hfdem::FixedPairs>;

namespace other_unit {

Kgd bonded(const Kgd::Params& params);
double pressure(const Kgd& simulator);
const std::type_info& type();
const std::string_view* version();

}  // namespace other_unit
