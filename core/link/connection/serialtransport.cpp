// SPDX-License-Identifier: MIT
#include "link/connection/serialtransport.h"

#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>

#include "link/clock.h"
#include "link/connection/linklog.h"
#include "link/ports/portuser.h"

namespace nmc {

namespace {

QString groupOf(const QByteArray& path) {
    struct stat info {};
    if (::stat(path.constData(), &info) != 0)
        return {};
    const group* entry = ::getgrgid(info.st_gid);
    return entry != nullptr ? QString::fromLocal8Bit(entry->gr_name) : QString();
}

QString userName() {
    const passwd* entry = ::getpwuid(::geteuid());
    return entry != nullptr ? QString::fromLocal8Bit(entry->pw_name) : QString();
}

}  // namespace

SerialTransport::SerialTransport(QString port, std::uint32_t baud, RateReader realRate)
    : m_name(std::move(port)), m_baud(baud), m_realRate(std::move(realRate)) {}

SerialTransport::~SerialTransport() = default;

tl::expected<void, PortError> SerialTransport::open() {
    m_port.setPortName(m_name);
    m_port.setBaudRate(static_cast<qint32>(kPowerUpBaud));
    m_port.setDataBits(QSerialPort::Data8);
    m_port.setParity(QSerialPort::NoParity);
    m_port.setStopBits(QSerialPort::OneStop);
    m_port.setFlowControl(QSerialPort::NoFlowControl);
    if (!m_port.open(QIODevice::ReadWrite))
        return tl::unexpected(openError());
    if (::flock(m_port.handle(), LOCK_EX | LOCK_NB) != 0) {
        m_port.close();
        qCDebug(portLog).noquote() << m_name << "is locked by somebody else";
        return tl::unexpected(whyBusy(m_name));
    }
    qCDebug(portLog).noquote() << m_name << "is open";
    return setBaud(m_baud).and_then([this] { return setBaud(kPowerUpBaud); });
}

tl::expected<void, PortError> SerialTransport::setBaud(std::uint32_t baud) {
    if (m_port.setBaudRate(static_cast<qint32>(baud))) {
        const auto real = m_realRate(m_port.handle());
        qCDebug(portLog).noquote() << m_name << "at" << baud << "Bd, really" << real.value_or(baud);
        if (!real || rateIsGoodEnough(baud, *real))
            return {};
        const QString detail = QStringLiteral("%1 Bd -> %2 Bd").arg(baud).arg(*real);
        return tl::unexpected(problem(PortProblem::RateNotPossible, detail));
    }
    if (m_port.error() == QSerialPort::ResourceError)
        return tl::unexpected(gone());
    return tl::unexpected(problem(PortProblem::RateNotPossible, m_port.errorString()));
}

tl::expected<void, PortError> SerialTransport::send(ByteSpan bytes) {
    const auto size = static_cast<qint64>(bytes.size());
    // Without flush() nothing is sent, because this thread has no event loop.
    if (m_port.write(reinterpret_cast<const char*>(bytes.data()), size) != size ||
        (m_port.bytesToWrite() > 0 && !m_port.flush() && m_port.error() != QSerialPort::NoError))
        return tl::unexpected(gone());
    return {};
}

void SerialTransport::discardInput() {
    m_port.clear(QSerialPort::Input);
}

Transport::Received SerialTransport::receive(std::optional<TimePoint> until, int wakeFd) {
    std::array<pollfd, 2> fds{{{m_port.handle(), POLLIN, 0}, {wakeFd, POLLIN, 0}}};
    if (pollUntil(fds, until) <= 0)
        return std::vector<std::uint8_t>{};
    if ((fds[0].revents & POLLIN) != 0) {
        m_port.waitForReadyRead(0);
        const QByteArray bytes = m_port.readAll();
        if (!bytes.isEmpty())
            return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
    }
    // Readable without a byte, or hung up: the device is gone. Qt would report that forever; once is enough.
    if (fds[0].revents != 0)
        return tl::unexpected(gone());
    return std::vector<std::uint8_t>{};
}

PortError SerialTransport::openError() const {
    PortError error = problem(PortProblem::Other, m_port.errorString());
    const QByteArray path = devicePath(m_name).toLocal8Bit();
    struct stat info {};
    switch (m_port.error()) {
        case QSerialPort::DeviceNotFoundError:
            error.problem = PortProblem::NotFound;
            break;
        case QSerialPort::PermissionError:
            // Qt reports a held lock file as a permission error as well.
            if (::faccessat(AT_FDCWD, path.constData(), R_OK | W_OK, AT_EACCESS) == 0) {
                error = whyBusy(m_name);
                error.detail = m_port.errorString().toStdString();
                break;
            }
            error.problem = PortProblem::NoPermission;
            error.group = groupOf(path).toStdString();
            error.user = userName().toStdString();
            break;
        case QSerialPort::UnsupportedOperationError:
            error.problem = PortProblem::NotASerialPort;
            break;
        case QSerialPort::NoError:
        case QSerialPort::OpenError:
        case QSerialPort::WriteError:
        case QSerialPort::ReadError:
        case QSerialPort::ResourceError:
        case QSerialPort::UnknownError:
        case QSerialPort::TimeoutError:
        case QSerialPort::NotOpenError:
            if (::stat(path.constData(), &info) != 0)
                error.problem = PortProblem::NotFound;
            else if (!S_ISCHR(info.st_mode))
                error.problem = PortProblem::NotASerialPort;
            break;
    }
    return error;
}

PortError SerialTransport::gone() const {
    return problem(PortProblem::Gone, m_port.errorString());
}

PortError SerialTransport::problem(PortProblem what, const QString& detail) const {
    qCDebug(portLog).noquote() << m_name << "problem" << static_cast<int>(what) << detail;
    return {what, m_name.toStdString(), {}, {}, detail.toStdString()};
}

}  // namespace nmc
