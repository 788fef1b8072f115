// SPDX-License-Identifier: GPL-3.0-or-later
// Says that the file on disk is no longer what is being edited, and offers what can be done.
#pragma once

#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/questions/questions.h"
#include "ui/window/notice.h"

namespace drillwave {

class FileNotice : public Notice {
    Q_OBJECT

  public:
    /// All three must outlive the notice.
    FileNotice(Document& document, FileWatch& watch, Questions& questions, QWidget* parent = nullptr);

  private:
    void tell(FileWatch::State state);
    void reload();
    void keep();

    Document& m_document;
    FileWatch& m_watch;
    Questions& m_questions;
    QPushButton* m_reload;
};

}  // namespace drillwave
