// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "batch/table.hpp"

/// \file The table as Markdown, LaTeX, CSV and JSON.
namespace planescope {
namespace {

using Json = nlohmann::ordered_json;

/// Measures that some method has.
std::vector<TableMeasure> columns(const BatchTable& table) {
  std::vector<TableMeasure> used;
  for (const TableMeasure& measure : measures()) {
    const bool any = std::ranges::any_of(
        table.methods, [&](const TableRow& row) { return row.cells.contains(measure.key); });
    if (any) used.push_back(measure);
  }
  return used;
}

std::string fixed(double value, int digits, bool sign) {
  char text[64];
  std::snprintf(text, sizeof text, sign ? "%+.*f" : "%.*f", digits, value);
  return text;
}

/// `97.13 [96.20, 98.01]`
std::string cell(const TableMeasure& measure, const Estimate& e, bool sign) {
  const auto number = [&](double v) { return fixed(v * measure.scale, measure.digits, sign); };
  return number(e.value) + " [" + number(e.low) + ", " + number(e.high) + "]";
}

std::string row_name(const TableRow& row, const std::string& minus) {
  return row.against.empty() ? row.method : row.method + minus + row.against;
}

/// Scenes that a row is over: of its measures, the most.
std::size_t scenes_of(const TableRow& row) {
  std::size_t most = 0;
  for (const auto& [key, estimate] : row.cells) most = std::max(most, estimate.count);
  return most;
}

std::string markdown_rows(const std::vector<TableRow>& rows, const std::vector<TableMeasure>& shown,
                          std::size_t all_scenes) {
  std::string text;
  for (const TableRow& row : rows) {
    text += "| " + row_name(row, " - ") + " | " + std::to_string(scenes_of(row)) + " of " +
            std::to_string(all_scenes) + " |";
    for (const TableMeasure& measure : shown) {
      const auto found = row.cells.find(measure.key);
      text += found == row.cells.end()
                  ? " |"
                  : " " + cell(measure, found->second, !row.against.empty()) + " |";
    }
    text += "\n";
  }
  return text;
}

std::string latex_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '_' || c == '%' || c == '&' || c == '#') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string latex_rows(const std::vector<TableRow>& rows, const std::vector<TableMeasure>& shown) {
  std::string text;
  for (const TableRow& row : rows) {
    text += latex_text(row_name(row, " $-$ "));
    for (const TableMeasure& measure : shown) {
      const auto found = row.cells.find(measure.key);
      if (found == row.cells.end()) {
        text += " & --";
        continue;
      }
      const Estimate& e = found->second;
      const auto number = [&](double v) {
        return fixed(v * measure.scale, measure.digits, !row.against.empty());
      };
      text += " & $" + number(e.value) + "$ {\\scriptsize $[" + number(e.low) + ", " +
              number(e.high) + "]$}";
    }
    text += " \\\\\n";
  }
  return text;
}

/// The shortest text that is read back the same.
std::string exact(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

Json cells_json(const TableRow& row) {
  Json cells = Json::object();
  for (const TableMeasure& measure : measures()) {
    const auto found = row.cells.find(measure.key);
    if (found == row.cells.end()) continue;
    const Estimate& e = found->second;
    cells[measure.key] = {{"statistic", measure.median ? "median" : "mean"},
                          {"value", e.value},
                          {"low", e.low},
                          {"high", e.high},
                          {"scenes", e.count}};
  }
  return cells;
}

}  // namespace

std::string to_markdown(const BatchTable& table) {
  const std::vector<TableMeasure> shown = columns(table);
  std::string text = "| method | scenes |", rule = "|---|---|";
  for (const TableMeasure& measure : shown) {
    text += " " + measure.title + " |";
    rule += "---|";
  }
  text += "\n" + rule + "\n" + markdown_rows(table.methods, shown, table.scenes) +
          markdown_rows(table.differences, shown, table.scenes) +
          "\nMeans over scenes (of time: medians) with bootstrap 95 % intervals; differences are "
          "paired, scene by scene.\n";
  for (const TableFailure& failure : table.failures)
    text += "\nFailed: " + failure.scene + ", " + failure.method + ": " + failure.reason + "\n";
  return text;
}

std::string to_latex(const BatchTable& table) {
  const std::vector<TableMeasure> shown = columns(table);
  std::string text = "% \\usepackage{booktabs}\n\\begin{tabular}{l" +
                     std::string(shown.size(), 'r') + "}\n\\toprule\nMethod";
  for (const TableMeasure& measure : shown) {
    const auto unit = measure.title.rfind(' ');
    const std::string last = unit == std::string::npos ? "" : measure.title.substr(unit + 1);
    const bool has_unit =
        last == "%" || last == "deg" || last == "mm" || last == "s" || last == "bit";
    text += " & " + measure.latex + (has_unit ? " [" + latex_text(last) + "]" : "");
  }
  text += " \\\\\n\\midrule\n" + latex_rows(table.methods, shown);
  if (!table.differences.empty()) text += "\\midrule\n" + latex_rows(table.differences, shown);
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string to_csv(const BatchTable& table) {
  std::string text = "method,against,measure,value,low,high,scenes\n";
  for (const auto* rows : {&table.methods, &table.differences}) {
    for (const TableRow& row : *rows) {
      for (const TableMeasure& measure : measures()) {
        const auto found = row.cells.find(measure.key);
        if (found == row.cells.end()) continue;
        const Estimate& e = found->second;
        text += row.method + "," + row.against + "," + measure.key + "," + exact(e.value) + "," +
                exact(e.low) + "," + exact(e.high) + "," + std::to_string(e.count) + "\n";
      }
    }
  }
  return text;
}

std::string to_json(const BatchTable& table) {
  Json methods = Json::array(), differences = Json::array(), failures = Json::array(),
       scenes = Json::array();
  for (const TableRow& row : table.methods)
    methods.push_back({{"method", row.method}, {"measures", cells_json(row)}});
  for (const TableRow& row : table.differences) {
    differences.push_back(
        {{"method", row.method}, {"against", row.against}, {"measures", cells_json(row)}});
  }
  for (const TableFailure& f : table.failures)
    failures.push_back({{"scene", f.scene}, {"method", f.method}, {"reason", f.reason}});
  for (const TableScene& s : table.per_scene)
    scenes.push_back({{"scene", s.scene}, {"method", s.method}, {"measures", s.values}});
  const Json all = {
      {"planescope", PLANESCOPE_VERSION}, {"scenes", table.scenes}, {"methods", methods},
      {"differences", differences},       {"failures", failures},   {"per_scene", scenes}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace planescope
