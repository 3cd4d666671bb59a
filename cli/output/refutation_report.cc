// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/refutation_report.h"

#include "analysis/data/truth.h"
#include "analysis/studies/wrong_answers/refutation.h"
#include "analysis/studies/wrong_answers/wrong_answers.h"
#include "cli/output/json_text.h"
#include "engine/sweep/parameter_text.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

Instance instance_of(const Record& record, const GeneratorRegistry& generators) {
  const Component<Generator>& component = generators.find(record.generator);
  const auto generator =
      generators.make(record.generator, parameters_from(record.generator_parameters, component.parameters));
  return generator->generate({record.seed, record.n, record.N, record.repetition});
}

Json json_of(const Vector& v) { return std::vector<double>(v.begin(), v.end()); }

Json json_of(const BodyPieces& body) {
  Json centers = Json::array(), factors = Json::array();
  for (const auto center : body.centers.colwise()) centers.push_back(json_of(Vector(center)));
  for (const Eigen::MatrixXd& F : body.factors) {
    Json rows = Json::array();
    for (const auto row : F.rowwise()) rows.push_back(json_of(Vector(row)));
    factors.push_back(std::move(rows));
  }
  return {{"centers", std::move(centers)}, {"factors", std::move(factors)}};
}

Json json_of(const PointOfPieces& point) {
  return {{"weights", json_of(point.weights)}, {"z", json_of(point.z)}};
}

void put(const SeparatingNormal& proof, Json& json) { json["normal"] = json_of(proof.normal); }

void put(const ClosePoints& proof, Json& json) {
  json["point_1"] = json_of(proof.first);
  json["point_2"] = json_of(proof.second);
}

void put(const SurfaceAround& proof, Json& json) {
  json["triangles"] = proof.triangles;
  for (const ClosePoints& corner : proof.corners) {
    json["corners_1"].push_back(json_of(corner.first));
    json["corners_2"].push_back(json_of(corner.second));
  }
}

Json json_of(const Record& record, const Refutation& refutation) {
  const Quantity quantity = quantity_of(record);
  Json json = {{"method", record.method},
               {"method_parameters", record.method_parameters},
               {"generator_parameters", record.generator_parameters},
               {"n", record.n},
               {"N", record.N},
               {"seed", record.seed},
               {"repetition", record.repetition},
               {"tolerance", record.tolerance},
               {"quantity", std::string(to_string(quantity))},
               {"size", size_of_bodies(record)},
               {"answer", claimed_distance(record)},
               {"first", json_of(refutation.first)},
               {"second", json_of(refutation.second)}};
  std::visit([&json](const auto& proof) { put(proof, json); }, refutation.proof);
  if (quantity == Quantity::growth) {
    json["center_1"] = json_of(refutation.center_1);
    json["center_2"] = json_of(refutation.center_2);
    json["growth"] = refutation.proven;
  }
  return json;
}

bool is_wrong_answer(const Record& record, const KnownDistances& known) {
  const Verdict verdict = verdict_on(record, known(record));
  return verdict == Verdict::inexact || verdict == Verdict::wrong_sign;
}

std::string name_of(const Record& record) {
  return std::string(record.method) + " (" + std::string(record.method_parameters) + ") of " +
         std::string(record.generator_parameters) + ", seed " + std::to_string(record.seed) +
         ", repetition " + std::to_string(record.repetition);
}

}  // namespace

RefutationCount put_refutations(const std::vector<Record>& records, const Filter& filter,
                                const GeneratorRegistry& generators, const ByteSink& put) {
  RefutationCount count;
  const KnownDistances known(records);
  bool any = false;
  for (const Record& record : records) {
    if (!is_of_bodies(record) || !filter(record)) continue;
    any = true;
    if (!is_wrong_answer(record, known)) continue;
    ++count.wrong;
    const Instance instance = instance_of(record, generators);
    const auto refutation =
        refute(instance, claimed_distance(record), kWrongSignBeyond * unit_of_errors(record));
    if (!refutation) {
      if (count.open.empty()) count.open = name_of(record);
      continue;
    }
    ++count.refuted;
    put(json_text(json_of(record, *refutation)) + '\n');
  }
  if (!any) throw EmptySetError("--refutations: no record of the generator 'bodies' passes the filter");
  return count;
}

}  // namespace raygauge::cli
