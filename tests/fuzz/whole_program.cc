// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The whole program, a process each time, on files that were changed at random: no signal, no end but those
// that are documented, one line for what is refused, nothing that hangs. RAYGAUGE_FUZZ_INPUTS says how many
// inputs a format gets.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/fuzz/mutator.h"

namespace raygauge::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr int kFewPrograms = 6;
constexpr rlim_t kMostMemory = rlim_t{1} << 30;
constexpr rlim_t kMostSeconds = 10;                  // of processor time, on one input
constexpr auto kDeadlock = std::chrono::minutes(5);  // of any machine, without end
constexpr auto kPatience = std::chrono::seconds(1);  // then what can run for long is told to stop

/// How the program is asked about a file.
struct Use {
  std::string name;       // of the test
  std::string seeds;      // folder of the corpus
  std::string file;       // what the changed file is called
  std::string arguments;  // of the program
  int format = -1;        // mesh_file: the first byte of its seeds, which is not of the file
};

const std::vector<Use>& uses() {
  static const std::vector<Use> all = {
      {"csv", "point_file", "in.csv", "distance in.csv cross.csv --time-limit 1"},
      {"points_of_hdf5", "dataset", "in.h5", "distance in.h5:/A cross.csv --time-limit 1"},
      {"off", "mesh_file", "in.off", "distance in.off ball.toml --time-limit 1", 0},
      {"ply", "mesh_file", "in.ply", "distance in.ply ball.toml --time-limit 1", 1},
      {"stl", "mesh_file", "in.stl", "distance in.stl ball.toml --time-limit 1", 2},
      {"obj", "mesh_file", "in.obj", "distance in.obj ball.toml --time-limit 1", 3},
      {"collada", "mesh_file", "in.dae", "distance in.dae ball.toml --time-limit 1", 4},
      {"mesh_as_it_is", "mesh_file", "in.obj", "scene run mesh.toml -o out.h5 --force", 3},
      {"parts", "parts_file", "in.obj", "scene run parts.toml -o out.h5 --force"},
      {"cloud_of_pcd", "cloud_file", "in.pcd", "distance pcd.toml ball.toml --between"},
      {"cloud_of_csv", "point_file", "in.csv", "distance cloud.toml ball.toml --between"},
      {"cloud_of_hdf5", "dataset", "in.h5", "distance cloud_h5.toml ball.toml --between"},
      {"heights_of_pgm", "height_field", "in.pgm", "distance pgm.toml ball.toml --between"},
      {"heights_of_csv", "point_file", "in.csv", "distance heights.toml ball.toml --between"},
      {"heights_of_hdf5", "dataset", "in.h5", "distance heights_h5.toml ball.toml --between"},
      {"set_of_files", "set_with_files", "in.toml", "distance in.toml ball.toml --between"},
      {"set", "set_file", "in.toml", "distance in.toml ball.toml --time-limit 1"},
      {"two_sets", "set_file", "in.toml", "distance in.toml ball.toml --between --signed"},
      {"scene", "scene_file", "in.toml", "scene run in.toml -o out.h5 --force"},
      {"scene_explained", "scene_file", "in.toml", "scene explain in.toml --json"},
      {"motion", "motion_file", "in.csv", "scene run motion.toml -o out.h5 --force"},
      {"robot", "robot_file", "in.urdf", "scene run robot.toml -o out.h5 --force --skip-missing-meshes"},
      {"robot_collisions", "robot_file", "in.urdf", "scene collisions in.urdf --boxes 100"},
      {"semantics", "semantics_file", "in.srdf", "scene run semantics.toml -o out.h5 --force"},
      {"semantics_compared", "semantics_file", "in.srdf",
       "scene collisions crew.urdf --boxes 100 --compare in.srdf"},
      {"pairs", "pair_list", "in.csv", "run pairs.toml -o out.h5 --force"},
      {"experiment", "experiment_file", "in.toml", "run in.toml --dry-run"},
      {"results", "results_file", "in.h5", "info in.h5"},
      {"results_in_a_table", "results_file", "in.h5", "table in.h5"},
  };
  return all;
}

/// The other files that the commands name.
const std::vector<std::pair<std::string, std::string>>& companions() {
  static const std::string scene =
      "[time]\nto = 1\ninstants = 3\n[[body]]\nname = \"ball\"\nshape = { shape = \"ball\", center = [9, 0, "
      "0], radius "
      "= 1 }\n[[query]]\neffects = [\"separated\", \"distance\", \"clearance\"]\n";
  static const std::vector<std::pair<std::string, std::string>> all = {
      {"cross.csv", "1 0\n-1 0\n0 1\n0 -1\n"},
      {"ball.toml", "shape = \"ball\"\ncenter = [0, 0, 0]\nradius = 1\n"},
      {"mesh.toml",
       scene + "[[body]]\nname = \"in\"\nfile = \"in.obj\"\nmotion = { velocity = [1, 0, 0] }\n"},
      {"parts.toml", scene + "[[body]]\nname = \"in\"\nfile = \"in.obj\"\nas = \"parts\"\n"},
      {"pcd.toml", "shape = \"cloud\"\nfile = \"in.pcd\"\nradius = 0.1\n"},
      {"cloud.toml", "shape = \"cloud\"\nfile = \"in.csv\"\nradius = 0.1\n"},
      {"cloud_h5.toml", "shape = \"cloud\"\nfile = \"in.h5:/A\"\nradius = 0.1\n"},
      {"pgm.toml", "shape = \"height_field\"\nfile = \"in.pgm\"\nspacing = 0.5\nunit = 0.01\nfloor = -1\n"},
      {"heights.toml", "shape = \"height_field\"\nfile = \"in.csv\"\nspacing = 0.5\nunit = 1\nfloor = -9\n"},
      {"heights_h5.toml",
       "shape = \"height_field\"\nfile = \"in.h5:/A\"\nspacing = 0.5\nunit = 1\nfloor = -9\n"},
      {"motion.toml",
       scene + "[[body]]\nname = \"in\"\nshape = { shape = \"ball\", center = [0, 0, 0], radius = 1 }\n"
               "motion = { file = \"in.csv\" }\n"},
      {"robot.toml", scene + "[[robot]]\nurdf = \"in.urdf\"\n"},
      {"semantics.toml", scene + "[[robot]]\nurdf = \"crew.urdf\"\nsrdf = \"in.srdf\"\n"},
      {"crew.urdf",
       "<robot name=\"r\"><link name=\"u\"><collision><geometry><sphere "
       "radius=\"1\"/></geometry></collision></link>"
       "<link name=\"v\"><collision><origin xyz=\"3 0 0\"/><geometry><sphere "
       "radius=\"1\"/></geometry></collision>"
       "</link><link name=\"w\"><collision><geometry><sphere radius=\"0.5\"/></geometry></collision></link>"
       "<joint name=\"j\" type=\"revolute\"><origin xyz=\"0 0 9\"/><parent link=\"u\"/><child link=\"v\"/>"
       "<axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\"/></joint><joint name=\"f\" type=\"fixed\">"
       "<origin xyz=\"0 0 3\"/><parent link=\"v\"/><child link=\"w\"/></joint></robot>"},
      {"heights.csv", "1 2 3\n2 9 1\n0 4 1\n"},
      {"points.csv", "4 0 0\n5 0 0\n4 1 0\n4 0 1\n"},
      {"A.csv", "3 0.3 0.2\n4 1 0\n4 0 1\n"},
      {"Q.csv", "1 1 1\n-1 0 0\n0 -1 0\n0 0 -1\n"},
      {"pairs.toml",
       "[[generator]]\nname = \"files\"\npairs = \"in.csv\"\n[[method]]\nname = \"column_generation\"\n"},
  };
  return all;
}

std::vector<std::string> own_seeds(const Use& use) {
  std::vector<std::string> seeds;
  for (const std::string& seed : seeds_of(use.seeds)) {
    if (use.format < 0) {
      seeds.push_back(seed);
    } else if (!seed.empty() && static_cast<unsigned char>(seed.front()) % 5 == use.format) {
      seeds.push_back(seed.substr(1));
    }
  }
  return seeds;
}

void redirect(int descriptor, const char* file, int flags) {
  const int opened = ::open(file, flags, 0644);
  if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(126);
}

[[noreturn]] void run_program_on(const std::string& arguments) {
  redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  redirect(STDOUT_FILENO, "/dev/null", O_WRONLY);
  redirect(STDERR_FILENO, "errors", O_WRONLY | O_CREAT | O_TRUNC);
  const rlimit memory{kMostMemory, kMostMemory}, seconds{kMostSeconds, kMostSeconds}, core{0, 0};
  ::setrlimit(RLIMIT_DATA, &memory);
  ::setrlimit(RLIMIT_CPU, &seconds);
  ::setrlimit(RLIMIT_CORE, &core);
  std::istringstream words(arguments);
  std::vector<std::string> all = {"raygauge"};
  for (std::string word; words >> word;) all.push_back(word);
  std::vector<char*> argv;
  for (std::string& argument : all) argv.push_back(argument.data());
  argv.push_back(nullptr);
  ::execv(RAYGAUGE_PROGRAM, argv.data());
  ::_exit(127);
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What is wrong with how the program ended; "" where nothing is.
std::string complaint(int status, bool told_to_stop) {
  if (WIFSIGNALED(status)) {
    if (told_to_stop && WTERMSIG(status) == SIGINT) return "";
    return WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL ? "hangs"
                                                                      : ::strsignal(WTERMSIG(status));
  }
  const int code = WEXITSTATUS(status);
  if (told_to_stop && code == 128 + SIGINT) return "";
  if (code != 0 && code != 2 && code != 3) return "exit status " + std::to_string(code);
  std::istringstream errors(text_of("errors"));
  int refusals = 0;
  for (std::string line; std::getline(errors, line);) {
    refusals += line.starts_with("raygauge: ") ? 1 : 0;
    for (const char c : line)
      if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) return "a control character in an error";
  }
  if (code == 2 && refusals != 1) return "a refusal of " + std::to_string(refusals) + " lines";
  return "";
}

std::string complaint_of(const std::string& arguments) {
  using Clock = std::chrono::steady_clock;
  const pid_t child = ::fork();
  if (child < 0) return "no process";
  if (child == 0) run_program_on(arguments);
  int status = 0;
  const bool may_take_long = arguments.starts_with("scene");
  bool told_to_stop = false;
  const Clock::time_point start = Clock::now();
  while (::waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::microseconds(500));
    if (Clock::now() - start > kDeadlock) ::kill(child, SIGKILL);
    if (told_to_stop || !may_take_long || Clock::now() - start < kPatience) continue;
    told_to_stop = true;
    ::kill(child, SIGINT);
  }
  return complaint(status, told_to_stop);
}

class WholeProgram : public testing::TestWithParam<Use> {
 protected:
  void SetUp() override {
    before_ = fs::current_path();
    folder_ =
        fs::temp_directory_path() / ("raygauge-fuzz-" + std::to_string(::getpid()) + "-" + GetParam().name);
    fs::create_directories(folder_);
    fs::current_path(folder_);
    for (const auto& [name, text] : companions()) write(name, text);
  }
  void TearDown() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }
  static void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

 private:
  fs::path before_, folder_;
};

TEST_P(WholeProgram, EndsAsDocumentedOnChangedFiles) {
  const Use& use = GetParam();
  const std::vector<std::string> seeds = own_seeds(use);
  ASSERT_FALSE(seeds.empty());
  Mutator mutator(1);
  int findings = 0;
  for (int i = 0; i < inputs_wanted(kFewPrograms) && findings < 5; ++i) {
    const std::string input = mutator.changed(seeds);
    write(use.file, input);
    const std::string found = complaint_of(use.arguments);
    if (found.empty()) continue;
    const fs::path kept =
        fs::temp_directory_path() / ("raygauge-found-" + use.name + "-" + std::to_string(++findings));
    write(kept, input);
    ADD_FAILURE() << use.arguments << ": " << found << "; the input is kept in " << kept << "\n"
                  << text_of("errors");
  }
}

std::string name_of(const testing::TestParamInfo<Use>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Fuzz, WholeProgram, testing::ValuesIn(uses()), name_of);

}  // namespace
}  // namespace raygauge::fuzz
