# SPDX-License-Identifier: MIT
# Which field of each file does a JSON Schema refuse? python3 refused.py SCHEMA FILE ...
# prints a line a file: "-" where it refuses none, else the path as the reader of scenes writes it.
import json
import sys

import jsonschema


def path_text(parts):
    text = ''
    for part in parts:
        text += f'[{part}]' if isinstance(part, int) else f'.{part}' if text else part
    return text


def deepest(error):
    """Of alternatives, the one that came farthest: the others are of another kind."""
    while error.context:
        error = max(error.context, key=lambda one: (len(one.absolute_path), one.validator != 'type'))
    return error


def field_of(error):
    error = error if error.validator == 'oneOf' else deepest(error)
    parts = list(error.absolute_path)
    if error.validator == 'additionalProperties':
        parts += [name for name in error.instance if name not in error.schema['properties']][:1]
    if error.validator in ('required', 'dependentRequired'):
        parts += [name for name in error.message.split("'")[1:2]]
    return path_text(parts)


def read(path):
    with open(path, encoding='utf-8') as file:
        return json.load(file)


schema = read(sys.argv[1])
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for path in sys.argv[2:]:
    print(next((field_of(error) for error in validator.iter_errors(read(path))), '-'))
