// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_notice.h"

#include <QFileInfo>
#include <QPushButton>

namespace drillwave {

FileNotice::FileNotice(Document& document, FileWatch& watch, Questions& questions, QWidget* parent)
    : Notice(Tone::warning, parent),
      m_document(document),
      m_watch(watch),
      m_questions(questions),
      m_reload(
          addButton(tr("&Reload"), tr("Take the scenario from the file; Undo brings the present one back"))) {
    setObjectName(QStringLiteral("fileNotice"));
    m_reload->setObjectName(QStringLiteral("reload"));
    QPushButton* keep =
        addButton(tr("&Keep mine"), tr("Go on with the present scenario; saving writes it over the file"));
    keep->setObjectName(QStringLiteral("keep"));
    connect(m_reload, &QPushButton::clicked, this, &FileNotice::reload);
    connect(keep, &QPushButton::clicked, this, &FileNotice::keep);
    connect(this, &Notice::dismissed, &m_document, &Document::markUnsaved);
    connect(&m_watch, &FileWatch::differs, this, &FileNotice::tell);
    connect(&m_watch, &FileWatch::agrees, this, &QWidget::hide);
}

void FileNotice::tell(FileWatch::State state) {
    const QString name = QFileInfo(m_document.path()).fileName();
    m_reload->setVisible(state == FileWatch::State::changed);
    if (state == FileWatch::State::missing)
        say(tr("%1 has been deleted or moved. Saving writes it again.").arg(name));
    else if (m_document.isModified())
        say(tr("%1 has been changed by another program, and here as well.").arg(name));
    else
        say(tr("%1 has been changed by another program.").arg(name));
    // What is shown is in no file any more: closing must not drop it unasked.
    if (state == FileWatch::State::missing) m_document.markUnsaved();
}

void FileNotice::reload() {
    const QString problem = m_document.reload();
    if (problem.isEmpty())
        m_watch.check();
    else
        m_questions.tell(window(), Questions::Tone::failure, tr("The file cannot be reloaded."), problem);
}

void FileNotice::keep() {
    m_watch.accept();
    m_document.markUnsaved();
    hide();
}

}  // namespace drillwave
