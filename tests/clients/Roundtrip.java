// What a program in Java does with the service, through the client that openapi-generator makes of its document.
// Usage: java Roundtrip BASE SOURCE TARGET

import client.ApiClient;
import client.ApiException;
import client.api.BatchesApi;
import client.api.JobsApi;
import client.api.MeshesApi;
import client.api.ResultsApi;
import client.api.WebhooksApi;
import client.model.BatchDocument;
import client.model.BatchSubmissionDocument;
import client.model.JobDocument;
import client.model.JobState;
import client.model.MeshDocument;
import client.model.Method;
import client.model.NewWebhookDocument;
import client.model.PartialEnergyParameters;
import client.model.PartialInferenceParameters;
import client.model.PartialParameters;
import client.model.SubjectDocument;
import client.model.SubmissionDocument;
import client.model.SubmittedInputDocument;
import client.model.TemplateSide;
import client.model.ValidationDocument;
import client.model.WebhookDocument;
import java.io.File;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

public class Roundtrip {
  static JobsApi jobs;

  static void check(boolean holds, Object shown) {
    if (!holds) throw new AssertionError(shown);
  }

  static JobDocument finished(JobDocument job) throws ApiException {
    while (job.getState() == JobState.QUEUED || job.getState() == JobState.RUNNING) job = jobs.getJob(job.getId(), null, 20, null);
    return job;
  }

  // The generator writes bodies of bytes as JSON, so uploads are sent without it.
  static String upload(URI base, MeshesApi meshes, String path) throws Exception {
    HttpRequest request = HttpRequest.newBuilder(base.resolve("/v1/meshes")).header("content-type", "application/octet-stream")
        .POST(HttpRequest.BodyPublishers.ofFile(Path.of(path))).build();
    HttpResponse<String> sent = HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString());
    String location = sent.headers().firstValue("location").orElseThrow();
    MeshDocument mesh = meshes.getMesh(location.substring(location.lastIndexOf('/') + 1), null);
    check(mesh.getSuitable(), mesh);
    return mesh.getId();
  }

  static SubmissionDocument pair(String source, String target, PartialParameters parameters) {
    return new SubmissionDocument()
        .source(new SubmittedInputDocument().meshId(source))
        .target(new SubmittedInputDocument().meshId(target))
        .parameters(parameters);
  }

  public static void main(String[] arguments) throws Exception {
    URI base = URI.create(arguments[0]);
    ApiClient client = new ApiClient().setScheme(base.getScheme()).setHost(base.getHost()).setPort(base.getPort());
    jobs = new JobsApi(client);
    MeshesApi meshes = new MeshesApi(client);
    ResultsApi results = new ResultsApi(client);
    String source = upload(base, meshes, arguments[1]);
    String target = upload(base, meshes, arguments[2]);

    // Submit, wait, result.
    PartialParameters rigid = new PartialParameters().method(Method.RIGID).seed(3L).energy(new PartialEnergyParameters().alpha(2.0));
    Object sent = jobs.submitJob(pair(source, target, rigid), null, "java-1", null, null).getActualInstance();
    check(sent instanceof JobDocument, sent);
    JobDocument job = finished((JobDocument) sent);
    check(job.getParameters() == null, job);
    job = jobs.getJob(job.getId(), "*", null, null);
    check(job.getState() == JobState.SUCCEEDED && job.getParameters().getEnergy().getAlpha() == 2.0, job);
    Object again = jobs.submitJob(pair(source, target, rigid), null, "java-1", null, null).getActualInstance();
    check(((JobDocument) again).getId().equals(job.getId()), again);
    Object tried = jobs.submitJob(pair(source, target, rigid), true, null, null, null).getActualInstance();
    check(tried instanceof ValidationDocument, tried);
    check(results.getResult(job.getId(), null, null, null).getTransform().getMatrix().size() == 4, "transform");
    check(results.getCorrespondences(job.getId(), null, null, null, null).getSource().size() > 100, "correspondences");
    for (String format : List.of("json", "csv", "npy", "npz", "arrow", "parquet", "ply", "vtk", "vtp", "gifti", "glb")) {
      File file = results.downloadFile(job.getId(), "correspondences." + format, null, null, null, null, null);
      check(Files.size(file.toPath()) > 100, format);
    }

    // A batch, with the template as source.
    BatchesApi batches = new BatchesApi(client);
    BatchDocument batch = batches.submitBatch(
        new BatchSubmissionDocument().template(new SubmittedInputDocument().meshId(source)).templateAs(TemplateSide.SOURCE)
            .addSubjectsItem(new SubjectDocument().input(new SubmittedInputDocument().meshId(target)))
            .parameters(new PartialParameters().method(Method.RIGID).seed(9L)), null);
    while (!batch.getFinished()) batch = batches.getBatch(batch.getId(), 20, null);
    JobDocument member = batches.listBatchJobs(batch.getId(), null, null).getJobs().get(0);
    check(member.getSource().getHash().equals(source) && member.getState() == JobState.SUCCEEDED, member);

    // Errors and cancelling.
    try {
      jobs.cancelJob(job.getId());
      throw new AssertionError("a finished job was cancelled");
    } catch (ApiException error) {
      check(error.getCode() == 409 && error.getResponseBody().contains("/problems/job-finished"), error);
    }
    try {
      PartialParameters wrong = new PartialParameters().energy(new PartialEnergyParameters().alpha(-1.0));
      jobs.submitJob(pair(source, target, wrong), null, null, null, null);
      throw new AssertionError("alpha -1 was accepted");
    } catch (ApiException error) {
      check(error.getCode() == 422 && error.getResponseBody().contains("/parameters/energy/alpha"), error);
    }
    PartialParameters slow = new PartialParameters().method(Method.METROPOLIS)
        .inference(new PartialInferenceParameters().maxIterations(100_000));
    JobDocument long_ = (JobDocument) jobs.submitJob(pair(source, target, slow), null, null, null, null).getActualInstance();
    jobs.cancelJob(long_.getId());
    check(finished(long_).getState() == JobState.CANCELLED, long_);

    // Webhooks.
    WebhooksApi webhooks = new WebhooksApi(client);
    WebhookDocument hook =
        webhooks.createWebhook(new NewWebhookDocument().url("http://127.0.0.1:9/").addStatesItem(JobState.SUCCEEDED));
    check(hook.getSecret() != null, hook);
    webhooks.testWebhook(hook.getId());
    check(webhooks.listWebhooks(null, null).getWebhooks().stream().anyMatch(one -> one.getId().equals(hook.getId())), hook);
    webhooks.deleteWebhook(hook.getId());
    System.out.println("all of it");
  }
}
