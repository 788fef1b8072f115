// SPDX-License-Identifier: GPL-3.0-or-later
// Says that pages show one of many blows under the feed, and leads back to the single one.
#pragma once

#include <optional>

#include "ui/job/solved_blow.h"
#include "ui/window/notice.h"

namespace drillwave {

class Page;
class PageTabs;

/// Keeps which blow that is until it is sent away or forgotten; seen beside the pages that show it.
class MarchedNotice : public Notice {
    Q_OBJECT

  public:
    /// The pages must outlive it.
    explicit MarchedNotice(PageTabs& pages, QWidget* parent = nullptr);

    /// What `what` says in words.
    void open(const MarchedQuestion& blow, const QString& what);
    /// The scenario is another one.
    void forget();
    /// The blow that a page is to show in place of the single one.
    std::optional<MarchedQuestion> blowOf(const Page& page) const;

  signals:
    /// The user wants the single blow again.
    void singleWanted();

  private:
    void follow();

    PageTabs& m_pages;
    std::optional<MarchedQuestion> m_blow;
};

}  // namespace drillwave
