// Says that the file on disk is no longer what is being edited, and offers what can be done.
#pragma once

#include "ui/document.h"
#include "ui/file_watch.h"
#include "ui/notice.h"
#include "ui/questions.h"

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
