// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/data/columns.h"
#include "analysis/data/record_groups.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// The names of the parameters of generators and methods in the records, as columns are named: NAME, and
/// generator.NAME and method.NAME for those that share it with each other or with a column of the file.
/// In alphabetical order, the short ones first.
std::vector<std::string> parameter_names(const std::vector<Record>& records);

/// What a parameter is in a record, "" where it has none of that name. A short name means the generator's if
/// it has one, else the method's.
std::string parameter_text(const Record& record, const std::string& name);

/// A parameter as a column: of numbers if it is one in each record, else of texts.
AnalysisColumn parameter_column(const std::vector<Record>& records, const std::string& name);

/// The column of the file, the derived one or the parameter of that name. Throws UnknownNameError, which
/// lists all of them.
AnalysisColumn column_among(const std::vector<Record>& records, const std::string& name,
                            const std::string& place = "");

/// The parameters of a record's generator that are not the same in all records of that generator, as a text:
/// "separation=1.2"; "" where none varies. Texts that the others tell apart already, as the files of a pair
/// with a name, are left out.
class VaryingParameters {
 public:
  explicit VaryingParameters(const RecordGroups& records);

  std::string of_generator(const Record& record) const;
  std::string of_method(const Record& record) const;

 private:
  std::string varying_of(const char* kind, const std::string& owner, const std::string& parameters) const;

  std::vector<std::string> varying_;  ///< generator GENERATOR NAME and method LABEL NAME, sorted
};

/// The records as CSV, one a line: the columns of csv_text() and behind them one for each of
/// parameter_names() that is not there under a shorter name. Empty where a record has no such parameter.
std::string tidy_csv(const std::vector<Record>& records);

}  // namespace raygauge
