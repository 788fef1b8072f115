// SPDX-License-Identifier: GPL-3.0-or-later
// Says why a page of waves is empty, and rounds lengths so that it is not.
#pragma once

#include "ui/document/document.h"
#include "ui/job/solved_blow.h"
#include "ui/window/notice.h"

namespace drillwave {

class PageTabs;

/// Shown while the waves of the page were too many to be kept, where rounded lengths may help.
class WavesNotice : public Notice {
    Q_OBJECT

  public:
    /// Document and pages must outlive it.
    WavesNotice(Document& document, PageTabs& pages, QWidget* parent = nullptr);

    void present(const SolvedBlow& blow);

  private:
    QString changesText(const DrillString& rounded) const;

    Document& m_document;
};

}  // namespace drillwave
