// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/study_job.h"

namespace drillwave {

StudyActivity::StudyActivity(QObject* parent) : QObject(parent) {
    m_time.setSingleShot(true);
    connect(&m_time, &QTimer::timeout, this, [this] {
        if (m_state != StudyState::running) return;
        m_isOutOfTime = true;
        cancel();
    });
}

void StudyActivity::endTime() {
    m_isOutOfTime = false;
    m_time.stop();
}

void StudyActivity::startTime() {
    endTime();
    if (m_limit.count() > 0) m_time.start(m_limit);
}

}  // namespace drillwave
