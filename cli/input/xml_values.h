// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tinyxml2.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace raygauge::cli {

using XmlElement = tinyxml2::XMLElement;

/// An XML file and its root element. Throws InvalidParameterError, with file and line, for text that is not
/// XML or has other than one root.
class XmlFile {
 public:
  /// `text` came from `path`.
  XmlFile(std::string text, std::string path);

  const XmlElement& root() const { return *document_.RootElement(); }

  /// Throws InvalidParameterError "FILE:LINE: what".
  [[noreturn]] void refuse(const XmlElement& element, const std::string& what) const;

  // Attributes of an element. Those that are needed are refused where they are missing; numbers must be
  // finite.
  std::string text(const XmlElement& element, const char* name) const;
  double number(const XmlElement& element, const char* name) const;
  double number(const XmlElement& element, const char* name, double otherwise) const;
  double limit(const XmlElement& element,
               const char* name) const;  ///< may be infinite; 0 where it is missing
  Eigen::Vector3d vector(const XmlElement& element, const char* name, const Eigen::Vector3d& otherwise) const;
  std::vector<double> numbers(const XmlElement& element, const char* name) const;  ///< separated by blanks

 private:
  std::string path_;
  tinyxml2::XMLDocument document_;
};

/// An element and the file that it is of.
struct XmlNode {
  const XmlFile* file = nullptr;
  const XmlElement* element = nullptr;

  std::string text(const char* name) const { return file->text(*element, name); }
  [[noreturn]] void refuse(const std::string& what) const { file->refuse(*element, what); }
};

}  // namespace raygauge::cli
