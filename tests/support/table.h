// Reading the tables of tests/conformance: tab-separated values under one header row, "-" for an empty cell.
#pragma once

#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "math/vec.h"

namespace raywalk::test {

class Row {
 public:
  explicit Row(std::map<std::string, std::string> cells) : cells_(std::move(cells)) {}
  // The cell of a column; "" where the table has "-". Throws where the table has no such column.
  [[nodiscard]] const std::string& text(const std::string& column) const { return cells_.at(column); }
  [[nodiscard]] double number(const std::string& column) const { return std::stod(text(column)); }
  [[nodiscard]] std::vector<double> numbers(const std::string& column) const {
    std::vector<double> values;
    std::istringstream in(text(column));
    for (double value; in >> value;) values.push_back(value);
    return values;
  }
  [[nodiscard]] Vec3d vector(const std::string& column) const {
    const std::vector<double> values = numbers(column);
    return {values.at(0), values.at(1), values.at(2)};
  }

 private:
  std::map<std::string, std::string> cells_;
};

inline std::vector<std::string> split_at_tabs(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (std::size_t tab; (tab = line.find('\t', begin)) != std::string::npos; begin = tab + 1)
    cells.push_back(line.substr(begin, tab - begin));
  cells.push_back(line.substr(begin));
  return cells;
}

// The rows of tests/conformance/NAME. Throws where there is no such table.
inline std::vector<Row> read_table(const std::string& name) {
  std::ifstream in(std::string(RAYWALK_SOURCE_DIR) + "/tests/conformance/" + name);
  std::vector<Row> rows;
  std::string line;
  if (!std::getline(in, line)) throw std::runtime_error("no table tests/conformance/" + name);
  const std::vector<std::string> header = split_at_tabs(line);
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = split_at_tabs(line);
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = cells.at(i) == "-" ? "" : cells.at(i);
    rows.emplace_back(std::move(row));
  }
  return rows;
}

}  // namespace raywalk::test
