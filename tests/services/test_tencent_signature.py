"""The signature against the worked example of Tencent Cloud's documentation, "Signature v3"."""

from __future__ import annotations

from storyblender.services.tencent_signature import TencentKey, authorization

_KEY = TencentKey("AKIDz8krbsJ5yKBZQpn74WFkmLPx3*******", "Gu5t9xGARNpq86cd98joQYCN3*******")
_BODY = rb'{"Limit": 1, "Filters": [{"Values": ["\u672a\u547d\u540d"], "Name": "instance-name"}]}'


def test_the_published_example_is_signed_as_published() -> None:
    header = authorization(_KEY, "cvm", "cvm.tencentcloudapi.com", _BODY, 1551113065)
    assert header == (
        "TC3-HMAC-SHA256 Credential=AKIDz8krbsJ5yKBZQpn74WFkmLPx3*******/2019-02-25/cvm/tc3_request, "
        "SignedHeaders=content-type;host, "
        "Signature=2230eefd229f582d8b1b891af7107b91597240707d778ab3738f756258d7652c"
    )


def test_a_byte_more_is_another_signature() -> None:
    signed = [authorization(_KEY, "cvm", "cvm.tencentcloudapi.com", body, 1551113065) for body in (_BODY, _BODY + b" ")]
    assert signed[0] != signed[1]
