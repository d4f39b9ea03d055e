// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace ellipsoid_host {

/// The settings of the contact models as the command gave them: keywords with a value each, which
/// the models have accepted before.
class ModelSettings {
 public:
  ModelSettings() = default;
  ModelSettings(int count, char** arguments) {
    for (int k = 0; k + 1 < count; k += 2)
      values_[arguments[k]] = arguments[k + 1];
  }
  /// The value of a keyword; what holds without it if it is not given.
  std::string value(const std::string& keyword, const std::string& without) const {
    const auto found = values_.find(keyword);
    return found == values_.end() ? without : found->second;
  }
  bool is_on(const std::string& keyword, bool without = false) const {
    return value(keyword, without ? "on" : "off") == "on";
  }
  /// The keywords whose value is 'on'.
  std::vector<std::string> switched_on() const {
    std::vector<std::string> keywords;
    for (const auto& setting : values_)
      if (setting.second == "on")
        keywords.push_back(setting.first);
    return keywords;
  }
  int number(const std::string& keyword, int without) const {
    return std::stoi(value(keyword, std::to_string(without)));
  }

 private:
  std::map<std::string, std::string> values_;
};

} // namespace ellipsoid_host
