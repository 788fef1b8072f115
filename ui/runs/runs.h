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
    /// Number of the run, 0 … mostRuns − 1, which decides its letter, colour and dash pattern.
    int number = 0;
    QString name;               ///< what differs from another run, in words, such as "k 300 MN/m"
    ScenarioDocument contents;  ///< scenario with its text, which reverting restores
    /// Solved blow; nullptr until it is solved. If its `fault` is not empty, it could not be solved.
    SolvedBlowPtr blow;
    bool isShown = true;  ///< whether the run is drawn over the plots
    /// Coefficient of restitution stored in the file of the run; empty if the run is not from a file.
    std::optional<double> kept;
    std::string version = {};  ///< version of the program that computed `kept`

    /// Returns the letter of the run, such as "A".
    QString letter() const { return QString::fromStdString(runLetter(number)); }
    /// Returns letter and name of the run, such as "A  k 300 MN/m".
    QString title() const { return letter() + QStringLiteral("  ") + name; }
    bool isSolved() const { return blow && blow->fault.isEmpty(); }
};

/// Runs in the order in which they were pinned; never changed once made, so that threads can share them.
using RunList = std::vector<Run>;
using RunListPtr = std::shared_ptr<const RunList>;

/// Set of the pinned runs, at most mostRuns. Every change creates a new list. It does not depend on the
/// scenario that is being edited.
class Runs : public QObject {
    Q_OBJECT

  public:
    /// Creates an empty set. Runs are named in the units of `units`, which must outlive the set.
    explicit Runs(const UnitChoice& units, QObject* parent = nullptr) : QObject(parent), m_units(units) {}

    const RunListPtr& list() const { return m_list; }
    /// Returns the run with this number; nullptr if there is none.
    const Run* find(int number) const;
    /// Returns the run that all others and the present result are compared with; nullptr if it is the present
    /// result.
    const Run* reference() const;

    /// Adds a run and returns an empty text, or returns why this is impossible. Its name is its difference
    /// from the reference, or from the last run; without a difference it is `title`. The first run becomes
    /// the reference. If `blow` is nullptr, RunSolver solves it.
    QString pin(ScenarioDocument contents, SolvedBlowPtr blow, const QString& title);
    /// Adds stored runs with their numbers, or with others if theirs are in use. Runs that exist already,
    /// with the same scenario and name, are not added again. Returns the titles of the runs for which no
    /// number is free.
    QStringList add(const std::vector<KeptRun>& kept);
    /// Returns the runs in the form in which they are stored in files.
    std::vector<KeptRun> toKeep() const;
    /// Excludes numbers from use by new runs, because the files with these numbers belong to others.
    void reserve(std::vector<int> numbers) { m_reserved = std::move(numbers); }

    void remove(int number);
    void clear();
    /// Renames a run. An empty name changes nothing.
    void rename(int number, const QString& name);
    void setShown(int number, bool shown);
    /// Sets the reference run by its number; empty for the present result. An unknown number changes nothing.
    void setReference(std::optional<int> number);
    /// Sets the blow of a run that has none. Ignored if the run with this number has another scenario.
    void setBlow(int number, const SolvedBlowPtr& blow);

  signals:
    /// Reports that the list, one of its runs or the reference has changed.
    void changed();
    /// Reports that a stored run, computed again, has another result than in its file. `sentence` describes
    /// the difference.
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

/// Solver that computes the missing blows of runs, one after another, on its own thread.
class RunSolver : public QObject {
    Q_OBJECT

  public:
    /// Creates the solver. The runs must outlive it.
    explicit RunSolver(Runs& runs, QObject* parent = nullptr);

    bool isBusy() const { return m_job.isBusy(); }

  private:
    void solveNext();

    Runs& m_runs;
    int m_number = -1;  // number of the run that is being solved; −1 for none
    SolveJob m_job;     // destroyed first, because its thread uses other members
};

// Runs that can be drawn over a blow.

/// Returns the runs of the same kind as the scenario, uniform rod or drill string. Runs of the other kind
/// have other axes.
RunList runsLike(const Scenario& scenario, const RunList& runs);

}  // namespace drillwave
