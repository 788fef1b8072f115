// SPDX-License-Identifier: GPL-3.0-or-later
// Says that the file of a measured blow has changed on disk, and offers to read it again.
#pragma once

#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/questions/questions.h"
#include "ui/window/notice.h"

namespace drillwave {

class TableNotice : public Notice {
    Q_OBJECT

  public:
    /// All three must outlive the notice.
    TableNotice(Document& document, TableWatch& watch, Questions& questions, QWidget* parent = nullptr);

  private:
    void tell(TableWatch::State state);
    void reload();

    Document& m_document;
    Questions& m_questions;
    QPushButton* m_reload;
};

}  // namespace drillwave
