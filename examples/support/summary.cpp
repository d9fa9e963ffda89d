#include "support/summary.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <nlohmann/json.hpp>

namespace hfdem::support {

using Json = nlohmann::ordered_json;

struct Summary::Document {
  Json root = Json::object();
  Json& at(const std::string& path) { return root[Json::json_pointer("/" + path)]; }
};

namespace {

/// A number with twelve digits: rounding noise of the last ones is no result.
Json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return std::strtod(text, nullptr);
}

}  // namespace

Summary::Summary() : document_(std::make_unique<Document>()) {}
Summary::~Summary() = default;
Summary::Summary(Summary&&) noexcept = default;
Summary& Summary::operator=(Summary&&) noexcept = default;

void Summary::set(const std::string& path, double value) { document_->at(path) = rounded(value); }
void Summary::set(const std::string& path, long value) { document_->at(path) = value; }
void Summary::set(const std::string& path, bool value) { document_->at(path) = value; }
void Summary::set(const std::string& path, const std::string& value) {
  document_->at(path) = value;
}

void Summary::compare(const std::string& path, double ours, double reference) {
  set(path + "/ours", ours);
  set(path + "/reference", reference);
  set(path + "/relative_difference", (ours - reference) / reference);
}

std::string Summary::json() const { return document_->root.dump(2) + "\n"; }

}  // namespace hfdem::support
