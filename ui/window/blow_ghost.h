// SPDX-License-Identifier: GPL-3.0-or-later
// Previous blow, drawn faintly behind the present one, to show the effect of a change.
#pragma once

#include <QObject>
#include <functional>

#include "ui/job/solved_blow.h"

namespace drillwave {

class Document;
class PageTabs;
class ScenarioPanel;

/// Object that draws the previous blow faintly under the curves of the present one, to show the effect of a
/// change. During a drag it is the blow before the drag. After choosing a preset it is the blow before the
/// preset, until the next change.
class BlowGhost : public QObject {
    Q_OBJECT

  public:
    using Shown = std::function<SolvedBlowPtr()>;

    /// Starts watching for drags and presets. `shown` returns the blow that is displayed now. All references
    /// must outlive this object.
    BlowGhost(Document& document, ScenarioPanel& panel, PageTabs& pages, const Shown& shown, QObject* parent);

  private:
    /// Time for which the blow from before a preset stays visible: `no` (not at all), `overThisChange` (while
    /// the preset is being set) or `untilTheNextChange`.
    enum class Stay { no, overThisChange, untilTheNextChange };

    void set(const SolvedBlowPtr& before);
    void followChange();

    PageTabs& m_pages;
    Stay m_stay = Stay::no;
};

}  // namespace drillwave
