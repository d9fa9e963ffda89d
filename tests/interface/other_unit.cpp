#include "other_unit.hpp"

namespace other_unit {

Kgd bonded(const Kgd::Params& params) { return {hfdem::square_array(8, 8, 5e-3), params}; }
double pressure(const Kgd& simulator) { return simulator.injection_pressure(); }
const std::type_info& type() { return typeid(Kgd); }
const std::string_view* version() { return &hfdem::version; }

}  // namespace other_unit
