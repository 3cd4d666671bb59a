// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/input/experiment_file.h"
#include "cli/input/registries.h"
#include "cluster/slurm.h"
#include "raygauge/exceptions.h"
#include "results/disk/atomic_file.h"
#include "results/run/output_place.h"
#include "results/text/language.h"

namespace raygauge::cli {
namespace fs = std::filesystem;
namespace {

constexpr const char* kSubmitFooter =
    "Options of sbatch may follow after --, as in -- --mem=4G. Tasks that reach the time limit, are "
    "preempted or "
    "requeued go on where they were. The scripts are kept beside the results file.";

struct SubmitArguments {
  std::string experiment_path;
  std::string output;
  std::vector<std::string> overrides;
  int shards = 0;
  bool slurm = false;
  bool print = false;
  std::string time;
  std::string partition;
  std::string account;
  int cpus_per_task = 1;
  std::vector<std::string> sbatch_options;
};

SlurmJob job_of(const SubmitArguments& arguments) {
  const Experiment experiment = read_experiment(arguments.experiment_path, arguments.overrides,
                                                sweep_generators(arguments.experiment_path), sweep_methods());
  SlurmJob job;
  job.program = fs::read_symlink("/proc/self/exe").string();
  job.experiment = fs::absolute(arguments.experiment_path).string();
  const std::string output = arguments.output.empty() ? "out/" + experiment.name + ".h5" : arguments.output;
  output_place({output, OutputKind::results, {".h5", ".hdf5"}, {arguments.experiment_path}, false});
  job.output = fs::absolute(output).string();
  job.name = experiment.name;
  job.shards = arguments.shards;
  for (const std::string& text : arguments.overrides)
    job.run_options.insert(job.run_options.end(), {"--set", text});
  if (!arguments.time.empty()) job.sbatch_options.push_back("--time=" + arguments.time);
  if (!arguments.partition.empty()) job.sbatch_options.push_back("--partition=" + arguments.partition);
  if (!arguments.account.empty()) job.sbatch_options.push_back("--account=" + arguments.account);
  job.sbatch_options.push_back("--cpus-per-task=" + std::to_string(arguments.cpus_per_task));
  for (const std::string& option : arguments.sbatch_options) job.sbatch_options.push_back(option);
  return job;
}

/// The number of the job that a call of sbatch has submitted.
std::string submitted(const std::string& options, const fs::path& script) {
  const std::string command = "sbatch --parsable " + options + " " + language::shell(script.string());
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw Error("sbatch cannot be started");
  std::string id;
  std::array<char, 64> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) id += buffer.data();
  const int status = ::pclose(pipe);
  id = id.substr(0, id.find_first_of(";\n"));
  if (status != 0 || id.empty()) {
    throw Error("sbatch has not taken " + script.string() + " (it tells why above)");
  }
  return id;
}

/// Whether a program of that name is on PATH.
bool on_path(const std::string& name) {
  const std::string path = std::getenv("PATH") == nullptr ? "" : std::getenv("PATH");
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find(':', begin), path.size());
    if (end > begin && fs::exists(fs::path(path.substr(begin, end - begin)) / name)) return true;
    begin = end + 1;
  }
  return false;
}

int submit(const SubmitArguments& arguments) {
  const SlurmJob job = job_of(arguments);
  if (arguments.print) {
    std::printf("%s\n%s", array_script(job).c_str(), merge_script(job).c_str());
    return kAnswered;
  }
  if (!on_path("sbatch")) {
    throw Error("there is no sbatch on this machine: submit where Slurm is, or see the scripts with --print");
  }
  fs::create_directories(fs::path(job.output).parent_path());
  const fs::path array = job.output + ".array.sbatch";
  const fs::path merge = job.output + ".merge.sbatch";
  write_atomically(array, array_script(job));
  write_atomically(merge, merge_script(job));
  const std::string array_id = submitted("", array);
  std::string options = "--dependency=afterany:" + array_id;
  if (!arguments.partition.empty()) options += " --partition=" + language::shell(arguments.partition);
  if (!arguments.account.empty()) options += " --account=" + language::shell(arguments.account);
  std::string merge_id;
  try {
    merge_id = submitted(options, merge);
  } catch (const Error& error) {  // an array without its merge would surprise
    const bool cancelled = std::system(("scancel " + array_id).c_str()) == 0;
    throw Error(error.what() + std::string("; the array ") + array_id +
                (cancelled ? " is cancelled" : " could not be cancelled"));
  }
  std::printf("array      %s, %d tasks\nmerge      %s, after the array\nresults    %s\n", array_id.c_str(),
              job.shards, merge_id.c_str(), job.output.c_str());
  return kAnswered;
}

}  // namespace

void add_submit_command(Command& app, int& status) {
  const auto arguments = std::make_shared<SubmitArguments>();
  Command command =
      app.add_subcommand("submit", "Submit a sweep to Slurm: a job array of shards, and the merge after it");
  command.add_option("experiment", arguments->experiment_path, "Experiment file")
      .required()
      .type_name("EXPERIMENT.toml");
  command.add_option("-o,--output", arguments->output, "Results file; default: out/NAME.h5")
      .type_name("FILE.h5");
  command.add_flag("--slurm", arguments->slurm, "The batch system; there is no other yet").required();
  command.add_option("--array", arguments->shards, "Tasks, each a shard of the cells")
      .required()
      .range(1, 100000)
      .type_name("K");
  command.add_option("--time", arguments->time, "Time limit of a task, as sbatch takes it").type_name("TIME");
  command.add_option("--partition", arguments->partition, "Partition").type_name("NAME");
  command.add_option("--account", arguments->account, "Account").type_name("NAME");
  command.add_option("--cpus-per-task", arguments->cpus_per_task, "CPUs, and threads, of a task")
      .range(1, 65536)
      .type_name("C");
  command.add_option("--set", arguments->overrides, "Replace a value of the experiment; may be repeated")
      .type_name("KEY=VALUE")
      .default_str("")
      .expected(1)
      .take_all();
  command.add_flag("--print", arguments->print, "Print the two scripts; submit nothing");
  command.add_option("sbatch", arguments->sbatch_options, "Further options of sbatch, after --")
      .type_name("OPTION...");
  command.footer(kSubmitFooter);
  command.callback([arguments, &status] { status = submit(*arguments); });
}

}  // namespace raygauge::cli
