// SPDX-License-Identifier: GPL-3.0-or-later
// The pinned runs, and which of them the others are compared with.
#pragma once

#include <QObject>
#include <functional>

#include "ui/runs/run.h"

namespace drillwave {

class UnitChoice;

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
    /// What the others, and the present result, are compared with; nullptr for the present result itself.
    const Run* reference() const;

    /// Adds a run, named by what changed against the reference, or the run before it; by `title` where there
    /// is none. The first one becomes the reference. `blow` may be nullptr: it is solved then. Returns why
    /// not.
    QString pin(ScenarioDocument contents, SolvedBlowPtr blow, const QString& title);
    /// Adds kept runs under their numbers where those are free. Those that are there already, with the same
    /// scenario and name, are not added again. Returns the titles of those for which there is no room.
    QStringList add(const std::vector<KeptRun>& kept);
    /// As they are kept.
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

}  // namespace drillwave
