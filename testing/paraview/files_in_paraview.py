"""Which reader ParaView opens a file with, and which writer it saves with, by the name alone; as one line of JSON.

    pvpython files_in_paraview.py PLUGIN FIXTURES OUT NAME ...
"""
import json
import pathlib
import sys

from paraview import servermanager, simple


def readers_of(path):
    path.touch()
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
    found = factory.GetReaders(str(path), servermanager.ActiveConnection.Session)
    names = [found.GetString(i) for i in range(found.GetNumberOfStrings())]
    return names[1::3]  # group, name and description of each


def writer_of(path, source):
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    writer = factory.CreateWriter(str(path), source.SMProxy, 0, False)
    if not writer:
        return None
    name = writer.GetXMLName()
    writer.UnRegister(None)
    return name


def main():
    plugin, fixtures, out, *names = sys.argv[1:]
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    out = pathlib.Path(out)
    sphere = simple.Sphere()
    sphere.UpdatePipeline()
    found = {name: [readers_of(out / name), writer_of(out / name, sphere)] for name in names}
    opened = simple.OpenDataFile(fixtures + "/bumpy_disk.off")
    opened.UpdatePipeline()
    simple.SaveData(str(out / "saved.gii"), proxy=opened)
    again = simple.OpenDataFile(str(out / "saved.gii"))
    again.UpdatePipeline()
    found["points"] = [proxy.GetDataInformation().GetNumberOfPoints() for proxy in (opened, again)]
    print("RESULT " + json.dumps(found), flush=True)


main()
