"""Which hosts a service may send us to."""

from __future__ import annotations

import ipaddress
import socket
from urllib.parse import urlsplit

from storyblender.errors import ServiceFailure


def refuse_address(url: str, own: str) -> None:
    """Refuse a URL that leads anywhere but to the public web by https, or to the service's own host.

    Args:
        url: Where a request is about to go.
        own: Address of the service.

    Raises:
        ServiceFailure: It is refused.
    """
    try:
        to, home = urlsplit(url), urlsplit(own)
        host, _ = to.hostname or "", to.port
    except ValueError as error:
        raise ServiceFailure("it leads to an address that is none") from error
    if to.username is not None or to.password is not None or not host:
        raise ServiceFailure("it leads to an address that is none")
    if host == home.hostname and to.scheme in ("https", home.scheme):
        return
    if to.scheme != "https":
        raise ServiceFailure(f"it leads to an address that is not https ({to.scheme[:20]})")
    if is_near(host, resolve=True):
        raise ServiceFailure("it leads to a computer of the local network")


def is_near(host: str, *, resolve: bool = False) -> bool:
    """Tell whether a host is this computer or one of the local network.

    Args:
        host: A name or an address.
        resolve: Whether to look up the address of a name; a name that has none is not near.
    """
    if host == "localhost" or host.endswith(".localhost"):
        return True
    try:
        addresses = {host.strip("[]")}
        if resolve and not _is_address(host):
            addresses = {str(found[4][0]) for found in socket.getaddrinfo(host, None)}
        return any(
            _is_address(each) and not ipaddress.ip_address(each.partition("%")[0]).is_global for each in addresses
        )
    except (OSError, UnicodeError):
        return False


def _is_address(text: str) -> bool:
    try:
        ipaddress.ip_address(text.partition("%")[0].strip("[]"))
    except ValueError:
        return False
    return True
