"""The stub names what the module has, and no more."""

import ast
import pathlib

import terrella
from terrella import _terrella


def test_stub_has_every_name():
    stub = ast.parse((pathlib.Path(terrella.__file__).parent / "_terrella.pyi").read_text())
    named = {node.name for node in stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    named |= {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
    assert named == {name for name in dir(_terrella) if not name.startswith("_")}
