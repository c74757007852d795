"""The signature of requests to Tencent Cloud: TC3-HMAC-SHA256, version 3 of its API."""

from __future__ import annotations

import hashlib
import hmac
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Final

CONTENT_TYPE: Final = "application/json; charset=utf-8"
_ALGORITHM: Final = "TC3-HMAC-SHA256"
_SIGNED: Final = "content-type;host"


@dataclass(frozen=True)
class TencentKey:
    """The key of an account.

    Attributes:
        secret_id: Names the key; it is sent.
        secret_key: Signs; it is never sent.
    """

    secret_id: str
    secret_key: str


def authorization(key: TencentKey, service: str, host: str, body: bytes, seconds: int) -> str:
    """Return the header ``Authorization`` of a request: POST to ``/`` with ``CONTENT_TYPE``.

    Args:
        key: Of the account.
        service: As its host begins: ``ai3d``.
        host: As in the header ``Host``.
        body: As it is sent.
        seconds: Since 1970, as in the header ``X-TC-Timestamp``.
    """
    day = datetime.fromtimestamp(seconds, UTC).strftime("%Y-%m-%d")
    asked = f"POST\n/\n\ncontent-type:{CONTENT_TYPE}\nhost:{host}\n\n{_SIGNED}\n{hashlib.sha256(body).hexdigest()}"
    scope = f"{day}/{service}/tc3_request"
    text = f"{_ALGORITHM}\n{seconds}\n{scope}\n{hashlib.sha256(asked.encode()).hexdigest()}"
    signing = f"TC3{key.secret_key}".encode()
    for part in scope.split("/"):
        signing = _hmac(signing, part)
    signature = _hmac(signing, text).hex()
    return f"{_ALGORITHM} Credential={key.secret_id}/{scope}, SignedHeaders={_SIGNED}, Signature={signature}"


def _hmac(key: bytes, text: str) -> bytes:
    return hmac.new(key, text.encode(), hashlib.sha256).digest()
