#!/usr/bin/python3
"""docs/references.bib as a Markdown page with one anchor per key, so that the C++ reference needs no BibTeX.

    bibliography.py REFERENCES.bib BIBLIOGRAPHY.md
"""
import pathlib
import re
import sys


def entries(text):
    """(key, {field: value}) of every entry."""
    for entry in re.split(r"^@\w+", text, flags=re.M)[1:]:
        key, body = re.match(r"\{(\w+),(.*)", entry, flags=re.S).groups()
        fields = re.findall(r"(\w+)\s*=\s*\{((?:[^{}]|\{[^{}]*\})*)\}", body)
        yield key, {name: " ".join(value.split()) for name, value in fields}


def plain(text):
    accents = {r"\'": "\u0301", r"\`": "\u0300", r'\"': "\u0308", r"\^": "\u0302", r"\~": "\u0303", r"\c": "\u0327"}
    for command, accent in accents.items():
        text = re.sub(rf"\{{?{re.escape(command)}\s*\{{?(\w)\}}?\}}?", rf"\1{accent}", text)
    return text.replace("--", "–").replace("{", "").replace("}", "").replace("\\", "")


def line(key, fields):
    where = fields.get("journal") or fields.get("booktitle") or fields.get("publisher") or fields.get("howpublished", "")
    volume = " " + fields["volume"] if "volume" in fields else ""
    pages = ", " + fields["pages"] if "pages" in fields else ""
    doi = f", doi:{fields['doi']}" if "doi" in fields else ""
    authors = ", ".join(" ".join(reversed(name.split(", "))) for name in fields["author"].split(" and "))
    text = plain(f"{authors} ({fields['year']}). {fields['title']}. *{where}*{volume}{pages}{doi}.")
    return f"- @anchor {key} **{key}** {text}\n"


def main():
    source, target = map(pathlib.Path, sys.argv[1:])
    page = "# References {#references}\n\n" + "".join(line(*entry) for entry in entries(source.read_text()))
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(page)


if __name__ == "__main__":
    main()
