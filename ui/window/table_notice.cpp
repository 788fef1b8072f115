// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/table_notice.h"

#include <QFileInfo>
#include <QPushButton>

namespace drillwave {

TableNotice::TableNotice(Document& document, TableWatch& watch, Questions& questions, QWidget* parent)
    : Notice(Tone::warning, parent),
      m_document(document),
      m_questions(questions),
      m_reload(
          addButton(tr("&Reload"), tr("Read the hammer blow from the file again; Undo brings the present one "
                                      "back"))) {
    setObjectName(QStringLiteral("tableNotice"));
    m_reload->setObjectName(QStringLiteral("reloadBlow"));
    QPushButton* keep = addButton(tr("&Keep mine"), tr("Go on with the points that were read before"));
    keep->setObjectName(QStringLiteral("keepBlow"));
    connect(m_reload, &QPushButton::clicked, this, &TableNotice::reload);
    connect(keep, &QPushButton::clicked, this, &QWidget::hide);
    connect(&watch, &TableWatch::differs, this, &TableNotice::tell);
    connect(&watch, &TableWatch::agrees, this, &QWidget::hide);
}

void TableNotice::tell(TableWatch::State state) {
    const QString name = QFileInfo(m_document.tablePath()).fileName();
    m_reload->setVisible(state == TableWatch::State::changed);
    if (state == TableWatch::State::changed)
        say(tr("%1, the hammer blow of this scenario, has been changed by another program.").arg(name));
    else
        say(tr("%1, the hammer blow of this scenario, has been deleted or moved. Its points are still here, "
               "but the "
               "scenario cannot be opened without the file.")
                .arg(name));
}

void TableNotice::reload() {
    const QString problem = m_document.reloadTable();
    if (problem.isEmpty())
        hide();  // also where the numbers are the same, written otherwise
    else
        m_questions.tell(window(), Questions::Tone::failure, tr("The hammer blow cannot be read again."),
                         problem);
}

}  // namespace drillwave
