// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/questions.hpp"
#include "cli/values.hpp"
#include "explain_json.hpp"
#include "planescope/close_up.hpp"
#include "planescope/error.hpp"
#include "planescope/explain.hpp"
#include "planescope/explain_planes.hpp"

namespace planescope::cli {
namespace {

using Json = nlohmann::ordered_json;
using Kind = Question::Kind;

struct Arguments {
  Console console;
  Question question;
  std::filesystem::path folder, png;
  std::string size;
  std::size_t pictures = 1;
};

/// What is said, in both ways, and the pictures that show it.
struct Answer {
  std::string words;
  Json json;
};

/// Draws the first few findings: DIR/why.png, DIR/why-2.png ...
class Pictures {
 public:
  Pictures(const Arguments& a, const StoredScene& stored) : a_(a), stored_(stored) {
    if (!a.size.empty()) options_.size = parse_size("--size", a.size);
  }

  template <class Finding>
  void add(const Finding& finding) {
    if (a_.png.empty() || drawn_ >= a_.pictures) return;
    std::filesystem::path file = a_.png;
    if (++drawn_ > 1)
      file.replace_filename(file.stem().string() + "-" + std::to_string(drawn_) + ".png");
    draw_close_up(stored_, finding, options_, file);
    a_.console.say(file.string());
  }

 private:
  const Arguments& a_;
  const StoredScene& stored_;
  CloseUpOptions options_;
  std::size_t drawn_ = 0;
};

void print(const Arguments& a, const Answer& answer) {
  const std::string text =
      a.console.json ? answer.json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"
                     : answer.words;
  std::fputs(text.c_str(), stdout);
}

Flips flips(const Arguments& a) { return a.question.seeks_flips() ? Flips::Seek : Flips::Skip; }

/// Explains edges one by one.
void add_edges(Answer& answer, const std::vector<std::size_t>& edges, EdgeExplainer& explain,
               const Arguments& a, Pictures& pictures) {
  answer.json["edges"] = Json::array();
  for (const std::size_t e : edges) {
    const EdgeExplanation x = explain(e, flips(a));
    answer.json["edges"].push_back(to_json(x));
    answer.words += describe(x);
    pictures.add(x);
  }
}

std::vector<std::size_t> first(std::vector<std::size_t> edges, std::size_t count) {
  edges.resize(std::min(edges.size(), count));
  return edges;
}

Answer answer_segment(const Arguments& a, const StoredScene& stored, EdgeExplainer& explain,
                      Pictures& pictures) {
  const std::uint32_t label = a.question.numbers().first;
  const SegmentEdges found = edges_of_segment(stored.scene, label);
  Answer answer;
  answer.json = {
      {"segment", label}, {"inside", found.inside.size()}, {"border", found.border.size()}};
  answer.words = "segment " + std::to_string(label) + " is held together by " +
                 std::to_string(found.inside.size()) + " ON edges and bounded by " +
                 std::to_string(found.border.size()) + " edges; the weakest of each kind:\n";
  std::vector<std::size_t> edges = first(found.inside, a.question.count());
  for (const std::size_t e : first(found.border, a.question.count())) edges.push_back(e);
  add_edges(answer, edges, explain, a, pictures);
  return answer;
}

Answer answer_chain(const Arguments& a, const StoredScene& stored, EdgeExplainer& explain,
                    Pictures& pictures) {
  const Question& q = a.question;
  const auto [from, to] = q.between_places() ? std::pair(patch_at(stored.scene, q.place(stored, 0)),
                                                         patch_at(stored.scene, q.place(stored, 1)))
                                             : q.numbers();
  const Chain chain = chain_between(stored.scene, from, to);
  Answer answer;
  answer.words = describe(stored.scene, chain);
  answer.json = to_json(chain);
  pictures.add(chain);
  add_edges(answer, first(deciding_edges(stored.scene, chain), q.count()), explain, a, pictures);
  return answer;
}

Answer answer_wrong(const Arguments& a, const StoredScene& stored, EdgeExplainer& explain,
                    const std::vector<std::uint32_t>& truth, Pictures& pictures) {
  const Segmentation& scene = stored.scene;
  const auto errors = judge_edges(
      scene.edges, patch_truth(scene.graph.point_patch, truth, scene.graph.patches.size()));
  Answer answer;
  const ErrorSummary summary = summarise_errors(scene, errors, truth);
  answer.words = describe(summary);
  answer.json = to_json(summary);
  add_edges(answer,
            first(wrong_edges(scene.edges, errors, scene.segments.patch_label), a.question.count()),
            explain, a, pictures);
  return answer;
}

Answer answer_edges(const Arguments& a, const StoredScene& stored) {
  const Question& q = a.question;
  Pictures pictures(a, stored);
  EdgeExplainer explain(stored.scene);
  const std::vector<std::uint32_t> truth = q.truth(stored);
  if (!truth.empty())
    explain.set_truth(
        patch_truth(stored.scene.graph.point_patch, truth, stored.scene.graph.patches.size()));
  if (q.kind() == Kind::Segment) return answer_segment(a, stored, explain, pictures);
  if (q.kind() == Kind::Between) return answer_chain(a, stored, explain, pictures);
  if (q.kind() == Kind::Wrong) return answer_wrong(a, stored, explain, truth, pictures);
  Answer answer;
  const std::vector<std::size_t> edges =
      q.kind() == Kind::Edge
          ? std::vector{find_edge(stored.scene, q.numbers().first, q.numbers().second)}
      : q.kind() == Kind::Near ? edges_near(stored.scene, q.place(stored), q.count())
                               : weakest_edges(stored.scene, q.count());
  add_edges(answer, edges, explain, a, pictures);
  return answer;
}

Answer answer_planes(const Arguments& a, const StoredScene& stored) {
  PlaneExplainer explain(stored.scene);
  Pictures pictures(a, stored);
  if (a.question.kind() == Kind::Plane) {
    const auto x = explain.plane(a.question.numbers().first, a.question.truth(stored), flips(a));
    pictures.add(x);
    return {describe(x), to_json(x)};
  }
  const auto x = explain.missing(a.question.place(stored), 0, flips(a));
  pictures.add(x);
  return {describe(x), to_json(x)};
}

void run(Arguments& a) {
  a.question.check();
  if (!a.png.empty() && a.png.extension() != ".png")
    throw Error(Error::Kind::Usage,
                "-o is `" + a.png.string() + "`; it takes a name that ends in .png");
  const StoredScene stored = load_scene(a.folder);
  const bool planes = a.question.kind() == Kind::Plane || a.question.kind() == Kind::Missing;
  print(a, planes ? answer_planes(a, stored) : answer_edges(a, stored));
}

}  // namespace

Command add_explain(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "explain", "Why an edge is ON or OFF, a plane chosen or missing, and what would change it");
  command->add_option("DIR", a->folder, "Result folder of `planescope segment`")->required();
  a->question.declare(*command);
  command->add_option("-o,--picture", a->png, "A close-up of the first finding")->type_name("PNG");
  command
      ->add_option("--pictures", a->pictures, "Close-ups of the first N: name.png, name-2.png ...")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--size", a->size, "Size of a close-up with its words (1600x1000)")
      ->type_name("WxH");
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
