// SPDX-License-Identifier: GPL-3.0-or-later
// The pinned runs (results kept for comparison), and the run that the others are compared with.
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

// Pinned result: the scenario with its text, and its blow.

struct Run {
    /// Number of the run, from 0 to mostRuns − 1. It decides the letter, the colour and the dash pattern of
    /// the run.
    int number = 0;
    QString name;               ///< what differs from another run, in words, such as "k 300 MN/m"
    ScenarioDocument contents;  ///< scenario with its text, which reverting restores
    /// Result of the run; nullptr until it is computed. If its `fault` is not empty, the blow could not be
    /// solved.
    SolvedBlowPtr blow;
    bool isShown = true;  ///< whether the run is drawn over the plots
    /// Coefficient of restitution stored in the file of the run, which a new computation should reproduce.
    /// Empty if the run is not from a file.
    std::optional<double> kept;
    std::string version = {};  ///< version of the program that computed `kept`

    /// Returns the letter of the run, such as "A".
    QString letter() const { return QString::fromStdString(runLetter(number)); }
    /// Returns the letter and the name of the run, such as "A  k 300 MN/m", for legends and lists.
    QString title() const { return letter() + QStringLiteral("  ") + name; }
    bool isSolved() const { return blow && blow->fault.isEmpty(); }
};

/// Runs in the order in which they were pinned; never changed once made, so that threads can share them.
using RunList = std::vector<Run>;
using RunListPtr = std::shared_ptr<const RunList>;

/// Set of the pinned runs (results kept for comparison), at most mostRuns. Every change creates a new list,
/// so that threads can keep the former one. The set is the same for all scenarios that the user edits.
class Runs : public QObject {
    Q_OBJECT

  public:
    /// Creates an empty set. The name of a run states input values, such as "k 300 MN/m", in the units of
    /// `units`, which must outlive the set.
    explicit Runs(const UnitChoice& units, QObject* parent = nullptr) : QObject(parent), m_units(units) {}

    const RunListPtr& list() const { return m_list; }
    /// Returns the pinned run with this number; nullptr if there is none.
    const Run* find(int number) const;
    /// Returns the reference: the pinned run with which all other runs and the present result are compared.
    /// nullptr if they are compared with the present result.
    const Run* reference() const;

    /// Pins a scenario as a new run. Returns an empty text, or why this is impossible. The run is named after
    /// its difference from the reference or the last run; without a difference its name is `title`. The first
    /// run becomes the reference. If `blow` is nullptr, RunSolver solves it.
    QString pin(ScenarioDocument contents, SolvedBlowPtr blow, const QString& title);
    /// Adds pinned runs that were read from files. A run keeps its number, or gets a free one if its number
    /// is in use. Runs that exist already, with the same scenario and name, are not added again. Returns the
    /// titles of the runs for which no number is free.
    QStringList add(const std::vector<KeptRun>& kept);
    /// Returns all runs in the form in which they are written to files.
    std::vector<KeptRun> toKeep() const;
    /// Sets the numbers that new runs must not get, because files with these numbers in the folder do not
    /// belong to this list.
    void reserve(std::vector<int> numbers) { m_reserved = std::move(numbers); }

    void remove(int number);
    void clear();
    /// Renames a run. An empty name changes nothing.
    void rename(int number, const QString& name);
    void setShown(int number, bool shown);
    /// Sets the reference, with which all results are compared, to the run with this number. Empty for the
    /// present result. An unknown number changes nothing.
    void setReference(std::optional<int> number);
    /// Sets the result of a run that has none. Ignored if the run does not exist, has a result, or has
    /// another scenario than the blow.
    void setBlow(int number, const SolvedBlowPtr& blow);

  signals:
    /// Reports that the list of pinned runs, one of its runs or the choice of the reference run has changed.
    void changed();
    /// Reports that a run from a file was computed again and has another result than the file states.
    /// `sentence` describes the difference.
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

// Solves the runs that have no blow yet: runs from a file, and pinned points of a study.

/// Solver that computes the results of runs that have none, one after another, on its own thread.
class RunSolver : public QObject {
    Q_OBJECT

  public:
    /// Creates the solver for the runs that have no result yet. The runs must outlive it.
    explicit RunSolver(Runs& runs, QObject* parent = nullptr);

    bool isBusy() const { return m_job.isBusy(); }

  private:
    void solveNext();

    Runs& m_runs;
    int m_number = -1;  // number of the run that is being solved; −1 for none
    SolveJob m_job;     // destroyed first, because its thread uses other members
};

// Runs that can be drawn over a blow.

/// Returns the runs of the same kind as the scenario: either uniform rods or drill strings. Plots of the
/// other kind have other axes, so that its runs cannot be drawn in them.
RunList runsLike(const Scenario& scenario, const RunList& runs);

}  // namespace drillwave
