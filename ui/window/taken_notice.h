// SPDX-License-Identifier: GPL-3.0-or-later
// Says which value was taken from a plot, and takes it back.
#pragma once

#include "ui/document/document.h"
#include "ui/window/notice.h"

namespace drillwave {

class PageTabs;

/// Goes away with the next change of the scenario.
class TakenNotice : public Notice {
    Q_OBJECT

  public:
    /// Document and pages must outlive it.
    explicit TakenNotice(Document& document, QWidget* parent = nullptr);
    /// Listens to every page; once, when all pages are there.
    void follow(PageTabs& pages);

  private:
    Document& m_document;
    int m_step = -1;  // index of the undo stack after the step that is shown
};

}  // namespace drillwave
