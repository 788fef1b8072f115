// SPDX-License-Identifier: GPL-3.0-or-later
// The blow from before a change that stays faintly behind the one on show.
#pragma once

#include <QObject>
#include <functional>

#include "ui/job/solved_blow.h"

namespace drillwave {

class Document;
class PageTabs;
class ScenarioPanel;

/// Keeps the blow from before a drag until its end, and that from before a preset until the next
/// change.
class BlowGhost : public QObject {
    Q_OBJECT

  public:
    using Shown = std::function<SolvedBlowPtr()>;

    /// `shown` returns the blow on show; all references must outlive it.
    BlowGhost(Document& document, ScenarioPanel& panel, PageTabs& pages, const Shown& shown, QObject* parent);

  private:
    /// How long the blow before a preset stays.
    enum class Stay { no, overThisChange, untilTheNextChange };

    void set(const SolvedBlowPtr& before);
    void followChange();

    PageTabs& m_pages;
    Stay m_stay = Stay::no;
};

}  // namespace drillwave
