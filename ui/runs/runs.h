// SPDX-License-Identifier: GPL-3.0-or-later
// The pinned runs, and which of them the others are compared with.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/archive/kept_runs.h"
#include "ui/job/solve_job.h"
#include "ui/job/solved_blow.h"

namespace drillwave {

class UnitChoice;

// A pinned result: the scenario with its bytes, and its blow.

struct Run {
    int number = 0;              ///< 0 … mostRuns − 1: its letter, colour and dash
    QString name;                ///< what changed, in words
    ScenarioDocument contents;   ///< what reverting brings back
    SolvedBlowPtr blow;          ///< nullptr until it is solved; its `fault` is the reason if it could not be
    bool isShown = true;         ///< laid over the plots
    std::optional<double> kept;  ///< the e that its file has, where it is from one
    std::string version = {};    ///< of the program that had solved that

    /// "A".
    QString letter() const { return QString::fromStdString(runLetter(number)); }
    /// "A  k 300 MN/m".
    QString title() const { return letter() + QStringLiteral("  ") + name; }
    bool isSolved() const { return blow && blow->fault.isEmpty(); }
};

/// The runs in the order in which they were pinned; never changed once made, so that threads can share it.
using RunList = std::vector<Run>;
using RunListPtr = std::shared_ptr<const RunList>;

/// At most mostRuns. Every change makes a new list; nothing here depends on the scenario that is being
/// edited.
class Runs : public QObject {
    Q_OBJECT

  public:
    /// Runs are named in these units, which must outlive them.
    explicit Runs(const UnitChoice& units, QObject* parent = nullptr) : QObject(parent), m_units(units) {}

    const RunListPtr& list() const { return m_list; }
    /// nullptr where there is none of that number.
    const Run* find(int number) const;
    /// The run to compare the others and the present result with; nullptr for the present result itself.
    const Run* reference() const;

    /// Adds a run, named by what changed against the reference, or the run before it; by `title` where there
    /// is none. The first one becomes the reference. `blow` may be nullptr: it is solved then. Returns why
    /// not.
    QString pin(ScenarioDocument contents, SolvedBlowPtr blow, const QString& title);
    /// Adds kept runs under their numbers where those are free. Runs that exist already, with the same
    /// scenario and name, are not added again. Returns the titles of runs for which there is no room.
    QStringList add(const std::vector<KeptRun>& kept);
    /// Returns the runs in the form in which they are kept.
    std::vector<KeptRun> toKeep() const;
    /// Numbers that are not given to new runs: their files are somebody else's.
    void reserve(std::vector<int> numbers) { m_reserved = std::move(numbers); }

    void remove(int number);
    void clear();
    /// An empty name changes nothing.
    void rename(int number, const QString& name);
    void setShown(int number, bool shown);
    /// nullopt: the present result.
    void setReference(std::optional<int> number);
    /// The blow of a run that was added without. Ignored where the run is another one meanwhile.
    void setBlow(int number, const SolvedBlowPtr& blow);

  signals:
    /// The list, something in it, or the reference.
    void changed();
    /// A kept run has been solved to another result than it had: in a sentence.
    void differs(const QString& sentence);

  private:
    std::optional<int> freeNumber() const;
    void check(const Run& run);
    void change(int number, const std::function<void(Run&)>& change);
    void take(RunList list);

    const UnitChoice& m_units;
    RunListPtr m_list = std::make_shared<const RunList>();
    std::optional<int> m_reference;
    std::vector<int> m_reserved;
};

// Solves runs that have no blow yet: those of a file, and points of a study that were pinned.

/// Solves runs one after the other, on a thread of its own.
class RunSolver : public QObject {
    Q_OBJECT

  public:
    /// The runs must outlive it.
    explicit RunSolver(Runs& runs, QObject* parent = nullptr);

    bool isBusy() const { return m_job.isBusy(); }

  private:
    void solveNext();

    Runs& m_runs;
    int m_number = -1;  // of the run that is being solved
    SolveJob m_job;     // goes first: its thread solves
};

// Runs that can be laid over a blow.

/// Returns the runs on rods for a rod, on drill strings for a string: the others have other axes.
RunList runsLike(const Scenario& scenario, const RunList& runs);

}  // namespace drillwave
