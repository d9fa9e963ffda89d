#include "support/natural_fractures.hpp"

#include <hfdem/setup/joints.hpp>

namespace hfdem::support {

std::string in_lines(std::span<const NaturalFracture> fractures) {
  std::string text = fractures.empty() ? "" : "\n[fracture]\n";
  for (std::size_t k = 0; k < fractures.size(); ++k)
    text += std::to_string(k + 1) + " = " + to_text(fractures[k].from) + " to " +
            to_text(fractures[k].to) + "\n";
  return text;
}

void check(const NamedFractures& given, Vec2 box, const NaturalFracture& crack, double clearance) {
  check_fractures(given.fractures, box.x, box.y, given.names);
  keep_clear(given.fractures, 0.5 * (crack.from + crack.to), crack, clearance, given.names);
}

void put_into(Specimen& specimen, const NamedFractures& given) {
  if (given.fractures.empty()) return;
  check_fractures(given.fractures, specimen.width, specimen.height, given.names);
  insert_joints(specimen, given.fractures);
}

void save(const std::filesystem::path& path, std::span<const NaturalFracture> fractures) {
  save_fractures(path.string(), fractures);
}

}  // namespace hfdem::support
