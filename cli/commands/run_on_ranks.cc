// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <optional>
#include <sstream>

#include "cli/commands/commands.h"
#include "cli/commands/run_setup.h"
#include "cli/console/interrupt.h"
#include "cli/console/rank_job.h"
#include "cli/input/experiment_file.h"
#include "cli/input/registries.h"
#include "cli/output/progress.h"
#include "cluster/share.h"
#include "engine/threads/thread_pin.h"
#include "raygauge/exceptions.h"
#include "results/run/rank_journal.h"

namespace raygauge::cli {
namespace {

/// What rank 0 tells the others before the sweep.
struct Orders {
  std::string path;
  int session = 0;  ///< of rank 0; the others' follow
  RankDuty duty;
  int workers = 1;
  DoneCells done;
  bool nothing_to_do = false;
};

class RankRun {
 public:
  RankRun(Ranks& ranks, const RunArguments& arguments) : ranks_(ranks), arguments_(arguments) {}

  int run() {
    all_or_none(ranks_, [this] { prepare(); });
    distribute();
    if (orders_.nothing_to_do) return run_ ? report_done(arguments_, experiment_, *run_) : kAnswered;
    all_or_none(ranks_, [this] {
      const RecordSource source = {orders_.session + ranks_.rank(), machine_info().hostname, ranks_.rank()};
      if (!run_) journal_.emplace(orders_.path, experiment_, source);
    });
    const InterruptGuard guard(run_ && !arguments_.quiet ? kInterruptNotice : nullptr);
    sweep();
    std::vector<Calibration> calibrations;
    for (const std::string& text : ranks_.gather(to_text(summary_.calibration))) {
      calibrations.push_back(calibration_from_text(text));
    }
    all_or_none(ranks_, [&] {
      if (run_) run_->writer->finish(calibrations);
    });
    return finish();
  }

 private:
  void prepare() {
    experiment_ = read_experiment(arguments_.experiment_path, arguments_.overrides, generators_, methods_);
    if (arguments_.threads) experiment_.threads = *arguments_.threads;
  }

  /// Rank 0 opens the run and tells every rank its part.
  void distribute() {
    const RankMachines all = gather_machines(ranks_);
    std::string orders;
    std::vector<RankDuty> duties;
    all_or_none(ranks_, [&] {
      if (ranks_.rank() != 0) return;
      const int threads = experiment_.timing == TimingMode::serial ? 1 : experiment_.threads;
      duties = rank_duties(all.places, threads, experiment_.pins());
      require_serial_alone(duties);
      orders = open(all.machines, duties);
    });
    read_orders(ranks_.broadcast(orders));
    orders_.duty = duties_from_text(ranks_.broadcast(to_text(duties))).at(ranks_.rank());
  }

  void require_serial_alone(const std::vector<RankDuty>& duties) const {
    if (experiment_.timing != TimingMode::serial) return;
    for (const RankDuty& duty : duties) {
      if (duty.concurrency > 1) {
        throw InvalidParameterError(
            "timing = \"serial\" needs one rank on each machine, so that timed solves run alone");
      }
    }
  }

  std::string open(const std::vector<MachineInfo>& machines, const std::vector<RankDuty>& duties) {
    std::vector<Session> sessions;
    int workers = 0;
    for (std::size_t i = 0; i < duties.size(); ++i) {
      sessions.push_back(session_of(experiment_, duties[i].threads));
      sessions.back().machine = machines[i];
      sessions.back().rank = static_cast<int>(i);
      workers += duties[i].threads;
    }
    run_ = open_run(arguments_, experiment_, std::move(sessions));
    SweepShare share = share_of(workers);
    const bool nothing = pieces_to_do(experiment_, grid_of(experiment_), run_->done, share).empty();
    if (!nothing) run_->writer->begin();
    std::ostringstream text;
    text << run_->path << '\n'
         << nothing << ' ' << run_->writer->session() << ' ' << workers << '\n'
         << to_text(run_->done);
    return text.str();
  }

  void read_orders(const std::string& text) {
    std::istringstream in(text);
    std::getline(in, orders_.path);
    in >> orders_.nothing_to_do >> orders_.session >> orders_.workers >> std::ws;
    orders_.done = done_from_text(text.substr(static_cast<std::size_t>(in.tellg())));
  }

  SweepShare share_of(int workers) const {
    SweepShare share;
    if (arguments_.shard) share.shard = *arguments_.shard;
    share.processes = ranks_.count();
    share.workers = workers;
    return share;
  }

  void sweep() {
    RankCounter counter(ranks_);
    SweepShare share = share_of(orders_.workers);
    share.counter = &counter;
    share.threads = orders_.duty.threads;
    share.concurrency = orders_.duty.concurrency;
    share.cpus = orders_.duty.cpus;
    share.calibrates = orders_.duty.calibrates && experiment_.timing == TimingMode::parallel;
    bool waited = false;
    share.wait_for_the_rest = [&] {
      waited = true;
      ranks_.barrier();
    };
    ProgressDisplay display(stderr, orders_.done.whole().size());
    SweepHooks hooks;
    const pid_t parent = ::getppid();  // another one, once mpirun or the daemon that started us has died
    hooks.stop = [parent] { return InterruptGuard::signal() != 0 || ::getppid() != parent; };
    if (run_ && !arguments_.quiet) {
      hooks.progress = [&display](const SweepProgress& progress) { display.show(progress); };
    }
    RecordSink& sink = run_ ? static_cast<RecordSink&>(*run_->writer) : *journal_;
    all_or_none(ranks_, [&] {
      try {
        summary_ = run_sweep(experiment_, generators_, methods_, sink, orders_.done, hooks, share);
      } catch (...) {
        counter.abandon();
        if (!waited) ranks_.barrier();
        throw;
      }
      if (::getppid() != parent) ::_exit(kInterrupted);  // nobody is left to meet
    });
  }

  int finish() {
    if (!run_) return kAnswered;
    const std::size_t done = run_->writer->results().cells().size();
    summary_.cells_done = done - std::min(done, run_->done.whole().size());
    summary_.threads = orders_.workers;
    summary_.stopped = !arguments_.shard && !run_->writer->results().finished();
    return report_end(arguments_, experiment_, *run_, summary_);
  }

  Ranks& ranks_;
  const RunArguments& arguments_;
  const GeneratorRegistry generators_ = sweep_generators(arguments_.experiment_path);
  const MethodRegistry methods_ = sweep_methods();
  Experiment experiment_;
  Orders orders_;
  std::optional<OpenRun> run_;          ///< at rank 0
  std::optional<RankJournal> journal_;  ///< at the others
  SweepSummary summary_;
};

}  // namespace

int run_on_ranks(Ranks& ranks, const RunArguments& arguments) {
  try {
    return RankRun(ranks, arguments).run();
  } catch (const JobFailed&) {
    return kBadInput;
  }
}

}  // namespace raygauge::cli
