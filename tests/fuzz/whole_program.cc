// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The whole program, a process each time, on files that were changed at random: no signal, no end but those
// that are documented, one line for what is refused, nothing that hangs. Its own results files with a bit
// flipped: every command refuses them. RAYGAUGE_FUZZ_INPUTS says how many inputs a format gets.
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

#include "cli/commands/program.h"
#include "tests/fuzz/crew_file.h"
#include "tests/fuzz/limits.h"
#include "tests/fuzz/mutator.h"

namespace raygauge::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr int kFewPrograms = 6, kFewFlips = 40;
constexpr rlim_t kMostMemory = rlim_t{1} << 30;
constexpr rlim_t kMostSeconds = 10 * kSlower;        // of processor time, on one input
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
      {"gltf", "mesh_file", "in.gltf", "distance in.gltf ball.toml --time-limit 1", 5},
      {"mesh_as_it_is", "mesh_file", "in.obj", "scene run mesh.toml -o out.h5 --force", 3},
      {"parts", "parts_file", "in.obj", "scene run parts.toml -o out.h5 --force"},
      {"cloud_of_pcd", "cloud_file", "in.pcd", "distance pcd.toml ball.toml --between"},
      {"cloud_of_csv", "point_file", "in.csv", "distance cloud.toml ball.toml --between"},
      {"cloud_of_hdf5", "dataset", "in.h5", "distance cloud_h5.toml ball.toml --between"},
      {"cloud_of_ply", "cloud_file", "in.ply", "distance ply.toml ball.toml --between"},
      {"heights_of_pgm", "height_field", "in.pgm", "distance pgm.toml ball.toml --between"},
      {"heights_of_csv", "point_file", "in.csv", "distance heights.toml ball.toml --between"},
      {"heights_of_hdf5", "dataset", "in.h5", "distance heights_h5.toml ball.toml --between"},
      {"set_of_files", "set_with_files", "in.toml", "distance in.toml ball.toml --between"},
      {"set", "set_file", "in.toml", "distance in.toml ball.toml --time-limit 1"},
      {"two_sets", "set_file", "in.toml", "distance in.toml ball.toml --between --signed"},
      {"scene", "scene_file", "in.toml", "scene run in.toml -o out.h5 --force"},
      {"scene_explained", "scene_file", "in.toml", "scene explain in.toml --json"},
      {"motion", "motion_file", "in.csv", "scene run motion.toml -o out.h5 --force"},
      {"trajectory", "motion_file", "in.csv", "scene run trajectory.toml -o out.h5 --force"},
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

/// A results file, own.h5, of the program, and the commands that read it.
struct Own {
  std::string name, made_by;
  std::vector<std::string> readers;
};

const std::vector<Own>& own_results() {
  static const std::vector<std::string> of_all = {"info own.h5", "info own.h5 --json",
                                                  "report own.h5 -o page.html", "merge own.h5 -o merged.h5",
                                                  "export own.h5 --csv x.csv"};
  static const auto and_also = [](std::vector<std::string> more) {
    more.insert(more.end(), of_all.begin(), of_all.end());
    return more;
  };
  static const std::vector<Own> all = {
      {"sweep", "run small.toml -o own.h5",
       and_also({"table own.h5 --rows n --cols N", "plot own.h5 -o figures", "compare own.h5 sound.h5",
                 "compare sound.h5 own.h5", "run small.toml -o own.h5 --resume"})},
      {"scene", "scene run moving.toml -o own.h5",
       and_also({"table own.h5", "plot own.h5 -o x.svg", "scene run moving.toml -o own.h5 --resume"})},
      {"simulation", "scene simulate falling.toml -o own.h5",
       and_also({"table own.h5", "plot own.h5 -o x.svg", "scene simulate falling.toml -o own.h5 --resume"})},
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
      {"moving.toml",
       scene + "[[body]]\nname = \"b\"\nshape = { shape = \"ball\", center = [0, 0, 0], radius = 1 }\n"
               "motion = { velocity = [1, 0, 0] }\n"},
      {"falling.toml",
       "[time]\nto = 0.1\ninstants = 3\n[dynamics]\ngravity = [0, 0, -9.81]\n[[body]]\nname = \"ball\"\n"
       "shape = { shape = \"ball\", center = [0, 0, 0.1], radius = 0.1 }\nmass = 1\n[[body]]\n"
       "name = \"floor\"\nshape = { shape = \"box\", lower = [-1, -1, -2], upper = [1, 1, 0] }\n"
       "[[query]]\neffects = [\"distance\"]\n"},
      {"small.toml",
       "[sweep]\nn = 2\nN = [5, 6]\n[[generator]]\nname = \"example2\"\n[[method]]\n"
       "name = \"column_generation\"\n[run]\nwarmup = 0\nmin_seconds = 0.0\n"},
      {"pcd.toml", "shape = \"cloud\"\nfile = \"in.pcd\"\nradius = 0.1\n"},
      {"ply.toml", "shape = \"cloud\"\nfile = \"in.ply\"\nradius = 0.1\n"},
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
      {"trajectory.toml", scene + "[[robot]]\nurdf = \"crew.urdf\"\ntrajectory = \"in.csv\"\n"},
      {"semantics.toml", scene + "[[robot]]\nurdf = \"crew.urdf\"\nsrdf = \"in.srdf\"\n"},
      {"crew.urdf", kCrew},
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
    } else if (!seed.empty() && static_cast<unsigned char>(seed.front()) == use.format) {
      seeds.push_back(seed.substr(1));
    }
  }
  return seeds;
}

void redirect(int descriptor, const char* file, int flags) {
  const int opened = ::open(file, flags, 0644);
  if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(126);
}

enum class Process { anew, forked };  // the second is quicker, and good for what needs no threads

[[noreturn]] void run_program_on(const std::string& arguments, Process process) {
  redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  redirect(STDOUT_FILENO, "/dev/null", O_WRONLY);
  redirect(STDERR_FILENO, "errors", O_WRONLY | O_CREAT | O_TRUNC);
  limit_memory(kMostMemory);
  const rlimit seconds{kMostSeconds, kMostSeconds};
  ::setrlimit(RLIMIT_CPU, &seconds);
  std::istringstream words(arguments);
  std::vector<std::string> all = {"raygauge"};
  for (std::string word; words >> word;) all.push_back(word);
  std::vector<char*> argv;
  for (std::string& argument : all) argv.push_back(argument.data());
  argv.push_back(nullptr);
  if (process == Process::forked) ::_exit(cli::run_program(static_cast<int>(all.size()), argv.data()));
  ::execv(RAYGAUGE_PROGRAM, argv.data());
  ::_exit(127);
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// How the program may end: any way that is documented, or that one alone.
constexpr int kAnyEnd = -1, kAnswered = 0, kRefused = 2;

/// What is wrong with how the program ended; "" where nothing is.
std::string complaint(int status, bool told_to_stop, int wanted) {
  if (WIFSIGNALED(status)) {
    if (told_to_stop && WTERMSIG(status) == SIGINT) return "";
    return WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL ? "hangs"
                                                                      : ::strsignal(WTERMSIG(status));
  }
  const int code = WEXITSTATUS(status);
  if (told_to_stop && code == 128 + SIGINT) return "";
  const bool documented = code == kAnswered || code == kRefused || code == 3;
  if (wanted == kAnyEnd ? !documented : code != wanted) return "exit status " + std::to_string(code);
  std::istringstream errors(text_of("errors"));
  int refusals = 0;
  for (std::string line; std::getline(errors, line);) {
    refusals += line.starts_with("raygauge: ") ? 1 : 0;
    for (const char c : line)
      if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) return "a control character in an error";
  }
  if (code == kRefused && refusals != 1) return "a refusal of " + std::to_string(refusals) + " lines";
  return "";
}

std::string complaint_of(const std::string& arguments, int wanted = kAnyEnd,
                         Process process = Process::anew) {
  using Clock = std::chrono::steady_clock;
  const pid_t child = ::fork();
  if (child < 0) return "no process";
  if (child == 0) run_program_on(arguments, process);
  int status = 0;
  const bool may_take_long = wanted == kAnyEnd && arguments.starts_with("scene");
  bool told_to_stop = false;
  const Clock::time_point start = Clock::now();
  while (::waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::microseconds(500));
    if (Clock::now() - start > kDeadlock) ::kill(child, SIGKILL);
    if (told_to_stop || !may_take_long || Clock::now() - start < kPatience) continue;
    told_to_stop = true;
    ::kill(child, SIGINT);
  }
  return complaint(status, told_to_stop, wanted);
}

/// In a folder of its own, with the companions.
template <class Param>
class InFolder : public testing::TestWithParam<Param> {
 protected:
  void SetUp() override {
    before_ = fs::current_path();
    folder_ = fs::temp_directory_path() /
              ("raygauge-fuzz-" + std::to_string(::getpid()) + "-" + this->GetParam().name);
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

using WholeProgram = InFolder<Use>;
using OwnResults = InFolder<Own>;

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

TEST_P(OwnResults, AreRefusedWithABitFlipped) {
  const Own& own = GetParam();
  ASSERT_EQ(complaint_of(own.made_by, kAnswered), "") << text_of("errors");
  const std::string sound = text_of("own.h5");
  write("sound.h5", sound);
  for (const std::string& reader : own.readers)
    ASSERT_EQ(complaint_of(reader, kAnswered), "") << reader << "\n" << text_of("errors");
  fs::remove("merged.h5");
  Mutator mutator(1);
  for (int i = 0; i < inputs_wanted(kFewFlips); ++i) {
    const std::string damaged = mutator.flipped(sound);
    write("own.h5", damaged);
    const std::string& reader = own.readers[static_cast<std::size_t>(i) % own.readers.size()];
    ASSERT_EQ(complaint_of(reader, kRefused, Process::forked), "") << reader << ", flip " << i;
    ASSERT_NE(text_of("errors").find("own.h5: "), std::string::npos) << reader << ", flip " << i;
    ASSERT_EQ(text_of("own.h5"), damaged) << reader << " has changed its input, flip " << i;
  }
}

template <class Param>
std::string name_of(const testing::TestParamInfo<Param>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, WholeProgram, testing::ValuesIn(uses()), name_of<Use>);
INSTANTIATE_TEST_SUITE_P(Fuzz, OwnResults, testing::ValuesIn(own_results()), name_of<Own>);

}  // namespace
}  // namespace raygauge::fuzz
