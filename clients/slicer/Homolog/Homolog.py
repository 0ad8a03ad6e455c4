"""3D Slicer module: matches two segments or models with a homolog service. The work is done by HomologLib.matching."""

import qt
import slicer
import vtk
from HomologLib.matching import FINAL, Matcher, MatchingError
from slicer.ScriptedLoadableModule import (
    ScriptedLoadableModule,
    ScriptedLoadableModuleLogic,
    ScriptedLoadableModuleWidget,
)

POLL_MS = 500


class Homolog(ScriptedLoadableModule):
    """What Slicer lists."""

    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        parent.title = "Homolog"
        parent.categories = ["Registration", "Shape Analysis"]
        parent.dependencies = []
        parent.contributors = ["the homolog contributors"]
        parent.helpText = "Dense correspondence and rigid registration of two surfaces, by a homolog service."


class HomologWidget(ScriptedLoadableModuleWidget):
    """The window: two surfaces, the service, a button, the progress, what is shown."""

    def setup(self):
        ScriptedLoadableModuleWidget.setup(self)
        self.logic = HomologLogic()
        self.timer = qt.QTimer()
        self.timer.setInterval(POLL_MS)
        self.timer.connect("timeout()", self.onTimer)
        form = qt.QFormLayout()
        self.layout.addLayout(form)
        settings = slicer.app.settings()
        self.url = qt.QLineEdit(settings.value("Homolog/url", "http://127.0.0.1:8080"))
        self.key = qt.QLineEdit()
        self.key.setEchoMode(qt.QLineEdit.Password)
        self.key.setPlaceholderText("only where the service requires one; not stored")
        form.addRow("Service", self.url)
        form.addRow("API key", self.key)
        self.nodes, self.segments = {}, {}
        for side in ("source", "target"):
            selector = slicer.qMRMLNodeComboBox()
            selector.nodeTypes = ["vtkMRMLModelNode", "vtkMRMLSegmentationNode"]
            selector.addEnabled = selector.removeEnabled = False
            selector.setMRMLScene(slicer.mrmlScene)
            segment = qt.QComboBox()
            selector.connect("currentNodeChanged(vtkMRMLNode*)", lambda node, side=side: self.onNode(side, node))
            self.nodes[side], self.segments[side] = selector, segment
            form.addRow(side.capitalize(), selector)
            form.addRow("Segment", segment)
        self.run = qt.QPushButton("Match")
        self.run.connect("clicked()", self.onRun)
        self.bar = qt.QProgressBar()
        self.said = qt.QLabel()
        self.said.setWordWrap(True)
        self.overlay = qt.QComboBox()
        self.overlay.connect("currentTextChanged(QString)", self.onOverlay)
        form.addRow(self.run)
        form.addRow(self.bar)
        form.addRow(self.said)
        form.addRow("Color", self.overlay)
        self.layout.addStretch(1)
        for side in ("source", "target"):
            self.onNode(side, self.nodes[side].currentNode())

    def cleanup(self):
        self.timer.stop()

    def onNode(self, side, node):
        box = self.segments[side]
        box.clear()
        if node is not None and node.IsA("vtkMRMLSegmentationNode"):
            for segment in slicer.util.getSegmentIDs(node) if hasattr(slicer.util, "getSegmentIDs") else list(
                    node.GetSegmentation().GetSegmentIDs()):
                box.addItem(node.GetSegmentation().GetSegment(segment).GetName(), segment)
        box.setEnabled(box.count > 0)

    def onRun(self):
        if self.timer.isActive():
            self.logic.cancel()
            return
        try:
            surfaces = [self.logic.surface(self.nodes[side].currentNode(), self.segments[side].currentData) for side in
                        ("source", "target")]
            slicer.app.settings().setValue("Homolog/url", self.url.text)
            self.logic.submit(self.url.text, self.key.text, *surfaces)
        except MatchingError as error:
            self.said.text = str(error)
            return
        self.run.text, self.said.text = "Cancel", "Queued"
        self.timer.start()

    def onTimer(self):
        try:
            job = self.logic.look()
            progress = job.get("progress") or {}
            self.bar.value = round(100 * progress.get("fraction", 0))
            self.said.text = progress.get("message") or job["state"]
            if job["state"] not in FINAL:
                return
            self.timer.stop()
            self.run.text = "Match"
            self.said.text, overlays = self.logic.show(job, self.nodes["source"].currentNode())
            self.overlay.clear()
            self.overlay.addItems(list(overlays))
        except MatchingError as error:
            self.timer.stop()
            self.run.text, self.said.text = "Match", str(error)

    def onOverlay(self, name):
        self.logic.color(name)


class HomologLogic(ScriptedLoadableModuleLogic):
    """The scene: nodes to surfaces, answers to nodes."""

    def __init__(self):
        ScriptedLoadableModuleLogic.__init__(self)
        self.matcher = self.job_id = self.warped = None
        self.overlays = {}

    def surface(self, node, segment):
        """The surface of a model or of a segment, in the coordinates of the scene."""
        surface = vtk.vtkPolyData()
        if node is None:
            raise MatchingError("choose a source and a target")
        if node.IsA("vtkMRMLSegmentationNode"):
            if not segment:
                raise MatchingError("choose a segment")
            node.CreateClosedSurfaceRepresentation()
            node.GetClosedSurfaceRepresentation(segment, surface)
        else:
            surface.DeepCopy(node.GetPolyData())
        if node.GetParentTransformNode() is None:
            return surface
        to_world = vtk.vtkGeneralTransform()
        slicer.vtkMRMLTransformNode.GetTransformBetweenNodes(node.GetParentTransformNode(), None, to_world)
        moved = vtk.vtkTransformPolyDataFilter()
        moved.SetTransform(to_world)
        moved.SetInputData(surface)
        moved.Update()
        return moved.GetOutput()

    def submit(self, url, key, source, target):
        """Begins a match."""
        self.matcher = Matcher(url, key)
        self.job_id = self.matcher.submit(source, target)["id"]

    def look(self):
        """The job as it is now."""
        return self.matcher.job(self.job_id)

    def cancel(self):
        """Ends it."""
        self.matcher.cancel(self.job_id)

    def show(self, job, source_node):
        """Adds the warped model and the transform to the scene; a sentence for people and the overlays."""
        answer = self.matcher.answer(job)
        surface = answer.warped()
        self.overlays = answer.overlays(surface)
        name = source_node.GetName()
        self.warped = slicer.modules.models.logic().AddModel(surface)
        self.warped.SetName(f"{name} warped")
        transform = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLLinearTransformNode", f"{name} to target")
        transform.SetMatrixTransformToParent(answer.transform())
        return answer.verdict(), self.overlays

    def color(self, name):
        """Colors the warped model by one of its values."""
        if self.warped is None or name not in self.overlays:
            return
        display = self.warped.GetDisplayNode()
        display.SetActiveScalarName(name)
        display.SetScalarVisibility(True)
        display.SetAndObserveColorNodeID("vtkMRMLColorTableNodeFileViridis.txt")
        display.SetScalarRange(*self.overlays[name])
